#pragma once

#include "apps/lab/drift/live_evaluation.h"
#include "evaluation/network/live_network.h"

#include <QString>

namespace carina::lab
{

/// The drift experiment among real programs.
struct LiveSettings {
    QString program; ///< carina-lab, which starts itself again for the host and each participant
    std::size_t participants = 2; ///< the host is none of them
    StrategyKind strategy = StrategyKind::SessionClock;
    Duration longestLag = StrategyChoice{}.longestLag; ///< of local lag
    AsaParameters asa{};
    ActionScript::Settings script;
    std::uint32_t seed = 1;
    Duration warmUp = std::chrono::seconds{20}; ///< of the clocks, before the first action
    QString logs{};      ///< folder for what each wrote down; empty: not kept
    ViewFrames frames{}; ///< of the viewers
    /// As DriftScenario has it: every program has a disciplined clock that is off by at most this.
    /// Without it none has one, whatever the system's clock is.
    std::optional<Duration> externalClocks{};
};

/// What a scenario has beside the network, in the settings.
[[nodiscard]] LiveSettings liveSettingsOf(const DriftSettings& settings, const QString& program);

/// Largest of what is injected into the participants' clocks, which are spread evenly.
inline constexpr double kLiveOffset_ms = 250.0;
inline constexpr double kLiveSkew_ppm = 50.0;

/// Runs it, which takes as long as it says, and tells of its progress on stderr. Ends every program
/// that it started.
///
/// @returns Cancelled for a program that fails or does not come in; FileUnwritable; what
///          evaluateLive does.
[[nodiscard]] Result<LiveFigures> runLiveDrift(const LiveSettings& settings, LiveNetwork& network);

} // namespace carina::lab
