#pragma once

#include "engine/net/node/session_node.h"
#include "engine/sync/strategies/application_analysis.h"

#include <QString>

#include <optional>
#include <vector>

namespace carina
{

/// What the network does to one shared object; what is not known yet is nothing.
///
/// The limit is speed x delay: when an object begins or ceases to move so fast, nobody elsewhere
/// can know before one one-way delay is over, and is off by so much until then. Of an object that
/// is acted on it is that of the last action (ActionMeter).
struct ObjectFigures {
    QString name;
    std::optional<double> drift_deg{};
    std::optional<double> limit_deg{};
    std::optional<double> drift_mm{};
    std::optional<double> limit_mm{};
    std::optional<double> actions_per_s{}; ///< v_k
    std::optional<double> upshot_per_s{};  ///< v0 of the longest way from its owner to anybody
};

/// The network between this program and one participant; what is not known yet is nothing.
struct NetworkFigures {
    ParticipantId id;
    QString name;
    std::optional<double> roundTrip_ms{};
    std::vector<double> delays_ms{}; ///< H_p: one way, the newest last
    std::optional<double> meanDelay_ms{};
    std::optional<double> sigma_ms{};
    std::optional<double> probes_per_s{}; ///< gamma_0
    std::optional<double> clockOffset_s{};
    std::optional<double> clockError_ms{};
    std::optional<double> clockChange_ms{}; ///< of the offset since it was first known
    std::optional<double> clockChangeError_ms{};
    std::optional<double> clockErrorBound_ms{};
    std::optional<double> loss_percent{};
    std::vector<ObjectFigures> objects{};
};

/// Of everybody whom this node measures a path to, in the order of their ids.
[[nodiscard]] std::vector<NetworkFigures> networkFigures(const SessionNode& node);

} // namespace carina
