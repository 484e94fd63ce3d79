//! The Rosenbrock-Wanner method of Steinebach of order 5.

use super::method::{Linear, Method, Row, Solve, Stage};

/// The Rosenbrock-Wanner method Rodas5P of order 5(4), stiffly accurate and L-stable, with continuous output of
/// order 4; it needs the Jacobian.
///
/// The steps are so short that the continuous output is as good as their ends: stage nine is its error in the middle,
/// from its residual there. A stiff solution that is drawn to a curve may otherwise be right at the ends alone.
///
/// G. Steinebach, *Construction of Rosenbrock-Wanner method Rodas5P and numerical benchmarks within the Julia
/// Differential Equations package*, BIT Numerical Mathematics 63, 27 (2023).
#[derive(Clone, Copy, Debug)]
pub struct Rodas5P;

// Stages six to eight begin where the solution of the one before ends.
const SIXTH: Row = &[
    (1, -7.502846399306121),
    (2, 2.561846144803919),
    (3, -11.627539656261098),
    (4, -0.18268767659942256),
    (5, 0.030198172008377946),
];

impl Method for Rodas5P {
    const ORDER: usize = 5;
    const ERROR_ORDER: usize = 4;
    const DENSE_ORDER: usize = 4;
    const SOLVE: Solve = Solve::Linear(Linear {
        gamma: 0.21193756319429014,
        rows: &[
            &[],
            &[],
            &[(1, -14.155112264123755)],
            &[(1, -17.97296035885952), (2, -2.859693295451294)],
            &[(1, 147.12150275711716), (2, -1.41221402718213), (3, 71.68940251302358)],
            &[
                (1, 165.43517024871676),
                (2, -0.4592823456491126),
                (3, 42.90938336958603),
                (4, -5.961986721573306),
            ],
            &[
                (1, 24.854864614690072),
                (2, -3.0009227002832186),
                (3, 47.4931110020768),
                (4, 5.5814197821558125),
                (5, -0.6610691825249471),
            ],
            &[
                (1, 30.91273214028599),
                (2, -3.1208243349937974),
                (3, 77.79954646070892),
                (4, 34.28646028294783),
                (5, -19.097331116725623),
                (6, -28.087943162872662),
            ],
            &[
                (1, 37.80277123390563),
                (2, -3.2571969029072276),
                (3, 112.26918849496327),
                (4, 66.9347231244047),
                (5, -40.06618937091002),
                (6, -54.66780262877968),
                (7, -9.48861652309627),
            ],
            &LESS_SLOPE,
        ],
        by_time: &[
            0.0,
            0.21193756319429014,
            -0.42387512638858027,
            -0.3384627126235924,
            1.8046452872882734,
            2.325825639765069,
            0.0,
            0.0,
            0.0,
            0.0,
        ],
    });
    const STAGES: &'static [Stage] = &[
        Stage { c: 0.0, a: &[] },
        Stage { c: 0.0, a: &[] },
        Stage { c: 0.6358126895828704, a: &[(1, 3.0)] },
        Stage { c: 0.4095798393397535, a: &[(1, 2.849394379747939), (2, 0.45842242204463923)] },
        Stage {
            c: 0.9769306725060716,
            a: &[(1, -6.954028509809101), (2, 2.489845061869568), (3, -10.358996098473584)],
        },
        Stage {
            c: 0.4288403609558664,
            a: &[
                (1, 2.8029986275628964),
                (2, 0.5072464736228206),
                (3, -0.3988312541770524),
                (4, -0.04721187230404641),
            ],
        },
        Stage { c: 1.0, a: SIXTH },
        Stage { c: 1.0, a: &[SIXTH[0], SIXTH[1], SIXTH[2], SIXTH[3], SIXTH[4], (6, 1.0)] },
        Stage { c: 1.0, a: &[SIXTH[0], SIXTH[1], SIXTH[2], SIXTH[3], SIXTH[4], (6, 1.0), (7, 1.0)] },
        Stage { c: 0.5, a: &MIDDLE },
    ];
    const WEIGHTS: Row = &[SIXTH[0], SIXTH[1], SIXTH[2], SIXTH[3], SIXTH[4], (6, 1.0), (7, 1.0), (8, 1.0)];
    const ERROR: &'static [Row] = &[&[(8, 1.0)], &[(9, 1.0)]];
    const LARGER_ERROR: bool = true;
    const FIRST_SAME_AS_LAST: bool = false;
    const DENSE_STAGES: &'static [Stage] = &[];
    // Steinebach's d2 + x (d3 + x d4) is d2 + x ((d3 + d4) - (1 - x) d4). It does not use the derivatives at the
    // ends, which in a stiff system are errors of the state multiplied by large numbers.
    const DENSE_CUBIC: Option<[Row; 2]> = Some([&row(D2), &row(D3_AND_D4)]);
    const DENSE: &'static [Row] = &[&row(sum(-1.0, D4, [0.0; 8]))];
}

const D2: [f64; 8] = [
    25.948786856663858,
    -2.5579724845846235,
    10.433815404888879,
    -2.3679251022685204,
    0.524948541321073,
    1.1241088310450404,
    0.4272876194431874,
    -0.17202221070155493,
];
const D3: [f64; 8] = [
    -9.91568850695171,
    -0.9689944594115154,
    3.0438037242978453,
    -24.495224566215796,
    20.176138334709044,
    15.98066361424651,
    -6.789040303419874,
    -6.710236069923372,
];
const D4: [f64; 8] = [
    11.419903575922262,
    2.8879645146136994,
    72.92137995996029,
    80.12511834622643,
    -52.072871366152654,
    -59.78993625266729,
    -0.15582684282751913,
    4.883087185713722,
];
const D3_AND_D4: [f64; 8] = sum(1.0, D3, D4);
const ENDS: [f64; 8] = [SIXTH[0].1, SIXTH[1].1, SIXTH[2].1, SIXTH[3].1, SIXTH[4].1, 1.0, 1.0, 1.0];
// In the middle the output is y + (change + (d2 + (d3 + d4 / 2) / 2) / 2) / 2, its slope change + (d3 + d4) / 4.
const MIDDLE: [(usize, f64); 8] = row(sum(0.5, sum(0.5, sum(0.5, sum(0.5, D4, D3), D2), ENDS), [0.0; 8]));
const LESS_SLOPE: [(usize, f64); 8] = row(sum(-1.0, sum(0.25, D3_AND_D4, ENDS), [0.0; 8]));

const fn row(weights: [f64; 8]) -> [(usize, f64); 8] {
    let mut row = [(0, 0.0); 8];
    let mut i = 0;
    while i < 8 {
        row[i] = (i + 1, weights[i]);
        i += 1;
    }
    row
}

/// `factor x + y`.
const fn sum(factor: f64, x: [f64; 8], y: [f64; 8]) -> [f64; 8] {
    let mut sum = y;
    let mut i = 0;
    while i < 8 {
        sum[i] += factor * x[i];
        i += 1;
    }
    sum
}
