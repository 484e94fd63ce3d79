//! Cubic splines.

/// One cubic `[c0, c1, c2, c3]` from each abscissa to the next: value and two derivatives go on over the inner
/// abscissae, and over the second and the last but one the third does too ("not-a-knot": de Boor, A Practical
/// Guide to Splines, 1978, chapter IV). Two samples give a line and three a parabola.
///
/// The abscissae rise, without repetition.
pub(super) fn spline(x: &[f64], y: &[f64]) -> Vec<[f64; 4]> {
    let gap: Vec<_> = x.windows(2).map(|x| x[1] - x[0]).collect();
    let chord: Vec<_> = (0..gap.len()).map(|i| (y[i + 1] - y[i]) / gap[i]).collect();
    let bend = |i: usize| (chord[i + 1] - chord[i]) / (gap[i] + gap[i + 1]);
    match gap.len() {
        0 => Vec::new(),
        1 => vec![[y[0], chord[0], 0.0, 0.0]],
        2 => (0..2)
            .map(|i| {
                [
                    y[i],
                    if i == 0 { chord[0] - bend(0) * gap[0] } else { chord[0] + bend(0) * gap[0] },
                    bend(0),
                    0.0,
                ]
            })
            .collect(),
        pieces => {
            let slope = slopes(&gap, &chord);
            let piece = |i: usize| {
                let (here, next) = (slope[i] - chord[i], slope[i + 1] - chord[i]);
                [y[i], slope[i], -(2.0 * here + next) / gap[i], (here + next) / gap[i] / gap[i]]
            };
            (0..pieces).map(piece).collect()
        }
    }
}

/// The slopes of a spline of at least three pieces.
///
/// That the second derivative goes on over abscissa `i` reads
/// `h[i] m[i-1] + 2 (h[i-1] + h[i]) m[i] + h[i-1] m[i+1] = 3 (h[i] s[i-1] + h[i-1] s[i])` with gaps `h`, chords
/// `s` and slopes `m`. The conditions at the ends take `m[0]` and the last slope out of it, and leave a
/// diagonally dominant system.
fn slopes(h: &[f64], s: &[f64]) -> Vec<f64> {
    let last = h.len();
    let end = |near: usize, far: usize| {
        let both = h[near] + h[far];
        (both, (h[far] * (h[far] / both)) * s[near] + h[near] * (2.0 + h[far] / both) * s[far])
    };
    // The rows below the diagonal are eliminated from the first on: m[i] = right[i] - upper[i] m[i+1].
    let (mut upper, mut right) = (vec![0.0; last], vec![0.0; last]);
    for i in 1..last {
        let (lower, (mut diagonal, mut sum), above) = match i {
            1 => (0.0, end(0, 1), h[0]),
            _ if i == last - 1 => (h[i], end(i, i - 1), 0.0),
            _ => (h[i], (2.0 * (h[i - 1] + h[i]), 3.0 * (h[i] * s[i - 1] + h[i - 1] * s[i])), h[i - 1]),
        };
        diagonal -= lower * upper[i - 1];
        sum -= lower * right[i - 1];
        (upper[i], right[i]) = (above / diagonal, sum / diagonal);
    }
    let mut m = right;
    for i in (1..last - 1).rev() {
        m[i] -= upper[i] * m[i + 1];
    }
    // Equal third derivatives of the two pieces next to an end give the slope there.
    let outer = |near: usize, far: usize, inner: f64, innermost: f64| {
        let ratio = h[near] / h[far];
        2.0 * s[near] - inner + ratio * ratio * (inner + innermost - 2.0 * s[far])
    };
    m[0] = outer(0, 1, m[1], m[2]);
    m.push(outer(last - 1, last - 2, m[last - 1], m[last - 2]));
    m
}
