#pragma once

#include "engine/lungs/mechanics/respiratory_fold.h"
#include "engine/lungs/mechanics/tube_place.h"

#include <array>

namespace carina
{

/// What diseases, anaesthesia and the tube make worse of the exchange of gas. Figures without a
/// source are ours.

/// Share of each lung's blood that meets no gas: 0.02 awake, 0.06 with relaxed muscles [textbooks:
/// 5 to 10 % in anaesthesia]; more in disease, by the severity s of a condition: ARDS 0.4 s,
/// asthma 0.1 s, COPD 0.08 s; half of what atelectasis closes (0.9 s) or a pneumothorax does (0.75
/// s), because hypoxic constriction takes the other half; of gas under tension likewise by the
/// share of the lung that it closes.
[[nodiscard]] std::array<double, 2> shuntOf(const LungConditions& conditions,
                                            const RespiratoryFold& breathing, bool isRelaxed);

/// Share of each lung's gas that meets no blood: the alveolar dead space of the mechanics.
[[nodiscard]] std::array<double, 2> wastedOf(const RespiratoryFold& breathing);

/// How unevenly a lung empties, as in GasMove: 0.8 t / (t + 1 s) with the time constant t of
/// expiration, resistance of the bronchi times compliance, and a kinked tube's obstruction besides.
[[nodiscard]] double slantOf(const LungMechanics& lung, double obstruction);

/// Share of exhaled gas in what the capnograph samples, at a part of an exhalation: a leaking cuff
/// and a kinked tube let fresh gas in; past a kink the exhaled gas comes late.
[[nodiscard]] double passingShare(const TubePlace& tube, double exhaled);

/// Gas that entered the pleura and stays there.
[[nodiscard]] Volume trappedGas(const RespiratoryFold& breathing);

} // namespace carina
