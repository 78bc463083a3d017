#include "apps/lab/figures/drift_source.h"

#include "apps/lab/drift/live_drift.h"

#include <QCoreApplication>

namespace carina::lab
{

DriftSource virtualDrift(int seeds)
{
    return {.byAction = {"none", "event", "asa-adaptive", "session-clock"},
            .byParticipants = {"event", "asa-adaptive", "session-clock"},
            .byDelay = allStrategies(),
            .speeds = {1.0, 10.0, 50.0, 100.0},
            .run = [seeds](const DriftSettings& settings) -> Result<DriftFigures> {
                return runDrift(settings, seeds);
            }};
}

std::vector<std::string_view> allStrategies()
{
    std::vector<std::string_view> names;
    for (const SyncStrategy& strategy : syncStrategies())
        names.push_back(strategy.name);
    return names;
}

DriftSource liveDrift(const std::vector<std::string_view>& strategies, Duration warmUp)
{
    return {.byAction = strategies,
            .byParticipants = strategies,
            .byDelay = strategies,
            .speeds = {100.0},
            .network = ", live",
            .run = [warmUp](const DriftSettings& settings) -> Result<DriftFigures> {
                const auto network =
                    relayedNetwork(settings.participants, settings.scenario, settings.seed);
                LiveSettings live =
                    liveSettingsOf(settings, QCoreApplication::applicationFilePath());
                live.warmUp = warmUp;
                return runLiveDrift(live, *network).map([](const LiveFigures& figures) {
                    return figures.drift;
                });
            }};
}

} // namespace carina::lab
