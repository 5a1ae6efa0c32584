//! Coefficients of Tsitouras's pair, all digits as published (*Comput. Math. Appl.* 62 (2011) 770, table 1 and section
//! 4). Zeros are left out.
#![expect(clippy::excessive_precision, reason = "the published digits, to be compared with the source")]

use crate::integrate::combination::StageWeights;

/// Stage 2.
pub(super) const A2: StageWeights<1> = [(0, 0.161)];

/// Stage 3.
pub(super) const A3: StageWeights<2> = [(0, -0.008480655492356989), (1, 0.335480655492357)];

/// Stage 4.
pub(super) const A4: StageWeights<3> =
    [(0, 2.8971530571054935), (1, -6.359448489975075), (2, 4.3622954328695815)];

/// Stage 5.
pub(super) const A5: StageWeights<4> =
    [(0, 5.325864828439257), (1, -11.748883564062828), (2, 7.4955393428898365), (3, -0.09249506636175525)];

/// Stage 6.
pub(super) const A6: StageWeights<5> = [
    (0, 5.86145544294642),
    (1, -12.92096931784711),
    (2, 8.159367898576159),
    (3, -0.071584973281401),
    (4, -0.028269050394068383),
];

/// The step, of order 5.
pub(super) const B: StageWeights<6> = [
    (0, 0.09646076681806523),
    (1, 0.01),
    (2, 0.4798896504144996),
    (3, 1.379008574103742),
    (4, -3.290069515436081),
    (5, 2.324710524099774),
];

/// The step less one of order 4.
pub(super) const ERROR: StageWeights<7> = [
    (0, -0.00178001105222577714),
    (1, -0.0008164344596567469),
    (2, 0.007880878010261995),
    (3, -0.1447110071732629),
    (4, 0.5823571654525552),
    (5, -0.45808210592918697),
    (6, 1.0 / 66.0),
];

/// The coefficients of θ⁴ in the weights bᵢ(θ) of the dense output.
pub(super) const QUARTIC: StageWeights<7> = [
    (0, -1.0530884977290216),
    (1, 0.1017),
    (2, 2.490627285651253),
    (3, -16.548102889244902),
    (4, 47.37952196281928),
    (5, -34.87065786149661),
    (6, 2.5),
];
