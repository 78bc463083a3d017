#include "apps/lab/figures/drift_source.h"

#include "apps/lab/drift/live_drift.h"

#include <QCoreApplication>

namespace carina::lab
{

DriftSource virtualDrift(int seeds)
{
    DriftSource source{.byAction = {"none", "event", "asa-adaptive", "session-clock"},
                       .byParticipants = {"event", "asa-adaptive", "session-clock"},
                       .speeds = {1.0, 10.0, 50.0, 100.0},
                       .run = [seeds](const DriftSettings& settings) -> Result<DriftFigures> {
                           return runDrift(settings, seeds);
                       }};
    for (const SyncStrategy& strategy : syncStrategies())
        source.byDelay.push_back(strategy.name);
    return source;
}

DriftSource liveDrift(Duration warmUp)
{
    const std::vector<std::string_view> ofThePaper{"event", "asa-adaptive", "session-clock"};
    return {.byAction = ofThePaper,
            .byParticipants = ofThePaper,
            .byDelay = {"asa-adaptive", "session-clock"},
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
