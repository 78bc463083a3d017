#pragma once

#include "engine/net/node/session_node.h"
#include "engine/sync/strategies/application_analysis.h"

#include <QString>

#include <optional>
#include <vector>

namespace carina
{

/// Up to which drift two programs show an object in the same place: the limit, and what neither the
/// network nor the programs are to blame for (trackedViewBound).
struct SameView {
    double deg = 0.0;
    double mm = 0.0;
    double percent = 0.0; ///< of the size
};

/// The drift that the network causes on one shared object. A figure is empty while it is unknown.
///
/// The limit is speed x one-way delay from the owner: when an object starts or stops to move at
/// that speed, no other participant can be informed before one delay has passed, and its view is
/// wrong by up to that much. For an object moved by actions it is that of an action that was under
/// way when the views were compared, and 0 where none was (ActionMeter).
struct ObjectFigures {
    QString name;
    std::optional<double> drift_deg{};
    std::optional<double> limit_deg{};
    std::optional<double> drift_mm{};
    std::optional<double> limit_mm{};
    std::optional<double> drift_percent{}; ///< of the size of an object that is acted on
    std::optional<double> limit_percent{};
    SameView same{};
};

/// Figures of the network between this program and one participant. A figure is empty while it is
/// unknown.
struct NetworkFigures {
    ParticipantId id;
    QString name;
    bool isOwn = false; ///< of this program's participant, to whom no path leads: actions alone
    std::optional<double> roundTrip_ms{};
    std::vector<double> delays_ms{}; ///< H_p: one-way delays, newest last
    std::optional<double> meanDelay_ms{};
    std::optional<double> sigma_ms{};
    std::optional<double> probes_per_s{}; ///< gamma_0 (adaptive probe rate)
    bool isOfStrategy = false; ///< delays and gamma_0: of the session's strategy, else of its clock
    std::optional<double> clockOffset_s{};
    std::optional<double> clockError_ms{};
    std::optional<double> clockChange_ms{}; ///< of the offset, since its first estimate
    std::optional<double> clockChangeError_ms{};
    std::optional<double> clockErrorBound_ms{};
    std::optional<ExternalVerdict> external{}; ///< of clocks disciplined from outside
    std::optional<double> loss_percent{};
    std::optional<TrafficReport> traffic{}; ///< at the host
    std::optional<double> actions_per_s{};  ///< v_k, the action frequency (ApplicationAnalysis)
    std::optional<double> upshot_per_s{};   ///< v0 = 1 / delay, for the longest path from them
    std::vector<ObjectFigures> objects{};
};

/// The figures of all participants to whom this node measures a path, in the order of their ids;
/// where there are any, after them those of this program's participant.
[[nodiscard]] std::vector<NetworkFigures> networkFigures(const SessionNode& node);

} // namespace carina
