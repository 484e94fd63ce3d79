//! Verner's method of order 8.

mod dense;

use super::method::{Method, Row, Stage};

/// The efficient Runge-Kutta method of Verner of order 8(7), with continuous output of order 7.
///
/// J. H. Verner (2010), Numerically optimal Runge-Kutta pairs with interpolants, *Numerical Algorithms* 53, 383-396.
///
/// His thirteenth stage is left out, for only his error estimate needs it. The error is estimated by the one sum of the
/// other stages that vanishes up to order 6; its size is chosen so that a tolerance means about what it means to
/// [`Dop853`](super::Dop853). His continuous output has large coefficients, whose roundings it would show; this
/// one is the polynomial that fits the ends, and the derivative there and at four of his stages.
#[derive(Clone, Copy, Debug)]
pub struct Vern8;

impl Method for Vern8 {
    const ORDER: usize = 8;
    const ERROR_ORDER: usize = 6;
    const DENSE_ORDER: usize = 7;
    const FIRST_SAME_AS_LAST: bool = false;
    const STAGES: &'static [Stage] = &[
        Stage { c: 0.0, a: &[] },
        Stage { c: 0.05, a: &[(0, 0.05)] },
        Stage { c: 0.1065625, a: &[(0, -0.006993164062500001), (1, 0.1135556640625)] },
        Stage { c: 0.15984375, a: &[(0, 0.0399609375), (2, 0.1198828125)] },
        Stage { c: 0.39, a: &[(0, 0.36139756280045765), (2, -1.3415240667004928), (3, 1.3701265039000352)] },
        Stage {
            c: 0.465,
            a: &[(0, 0.049047202797202816), (3, 0.23509720422144048), (4, 0.18085559298135673)],
        },
        Stage {
            c: 0.155,
            a: &[
                (0, 0.06169289044289044),
                (3, 0.11236568314640277),
                (4, -0.03885046071451367),
                (5, 0.019791887125220453),
            ],
        },
        Stage {
            c: 0.943,
            a: &[
                (0, -1.7676302402223292),
                (3, -62.5),
                (4, -6.061889377376669),
                (5, 5.6508231982227635),
                (6, 65.62169641937624),
            ],
        },
        Stage {
            c: 0.901802041735857,
            a: &[
                (0, -1.1809450665549708),
                (3, -41.50473441114321),
                (4, -4.434438319103725),
                (5, 4.260408188586133),
                (6, 43.75364022446172),
                (7, 0.007871425489911044),
            ],
        },
        Stage {
            c: 0.909,
            a: &[
                (0, -1.2814059994414884),
                (3, -45.047139960139866),
                (4, -4.731362069449577),
                (5, 4.514967016593808),
                (6, 47.44909557172985),
                (7, 0.010592282971116612),
                (8, -0.005746842263842394),
            ],
        },
        Stage {
            c: 0.94,
            a: &[
                (0, -1.7244701342624853),
                (3, -60.92349008483054),
                (4, -5.951518376222393),
                (5, 5.556523730698456),
                (6, 63.98301198033305),
                (7, 0.014642028250415856),
                (8, 0.06460408772358203),
                (9, -0.0793032316900888),
            ],
        },
        Stage {
            c: 1.0,
            a: &[
                (0, -3.301622667747072),
                (3, -118.01127235975251),
                (4, -10.141422388456112),
                (5, 9.139311332232058),
                (6, 123.37594282840426),
                (7, 4.62324437887458),
                (8, -3.3832777380682018),
                (9, 4.527592100324618),
                (10, -5.828495485811623),
            ],
        },
    ];
    const WEIGHTS: Row = &[
        (0, 0.04427989419007758),
        (5, 0.3541049391724449),
        (6, 0.2479692154956438),
        (7, -15.694202038838084),
        (8, 25.084064965558564),
        (9, -31.738367786260277),
        (10, 22.938283273988784),
        (11, -0.2361324633071542),
    ];
    const ERROR: &'static [Row] = &[&[
        (0, -4.754938664392248e-06),
        (5, -3.923199844264264e-05),
        (6, 1.4879149428024775e-05),
        (7, -0.16684090700411613),
        (8, 0.07473390508882463),
        (9, -0.1078638902970295),
        (10, 0.2),
    ]];
    const DENSE_STAGES: &'static [Stage] = dense::STAGES;
    const DENSE: &'static [Row] = dense::TERMS;
}
