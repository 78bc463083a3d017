#include "apps/lab/commands.h"
#include "apps/lab/drift/drift_measurement.h"
#include "apps/lab/drift/drift_page.h"
#include "apps/lab/drift/drift_table.h"

namespace carina::lab
{
namespace
{

Use driftInVirtualTime()
{
    return {.lines = {"--scenario NAME|FILE [OPTION...]"},
            .text = "Measures the drift between the participants' views of shared objects, in "
                    "virtual time. One of N participants turns one object and moves another, in "
                    "successive actions of 1.2 s, each about and along a new random axis; all "
                    "others watch. A host in the middle forwards everything. The figures are means "
                    "over the runs; an angle between two orientations is that of q_s q_c^-1, 2 "
                    "atan2(|v|, |w|). The same arguments print the same bytes.",
            .options = {drift_option::kOfAll.begin(), drift_option::kOfAll.end()},
            .schema = drift_key::kSchema,
            .keys = {drift_key::kStrategy,    drift_key::kParticipants, drift_key::kTurningSpeed,
                     drift_key::kMovingSpeed, drift_key::kActions,      drift_key::kActionTime,
                     drift_key::kAxes,        drift_key::kScenario,     drift_key::kExternalClocks,
                     drift_key::kLocalLag,    drift_key::kAsaDelays,    drift_key::kSeed,
                     drift_key::kSeeds,       drift_key::kAtEvent,      drift_key::kRawAtLast,
                     drift_key::kRawGreatest, drift_key::kTimeAverage,  drift_key::kPercentile,
                     drift_key::kLost,        drift_key::kShown,        drift_key::kPosition,
                     drift_key::kLimit,       drift_key::kRatio,        drift_key::kResponse,
                     drift_key::kClockError,  drift_key::kBytes,        drift_key::kProbes,
                     drift_key::kAccessLink}};
}

Use driftInRealTime()
{
    return {
        .lines = {"--live --scenario NAME|FILE [OPTION...] [--netlab PROGRAM] [--warm-up-s T] "
                  "[--logs DIR]"},
        .text =
            "The same in real time: one program for the host and one for each participant, "
            "over encrypted sockets and relays that imitate the network of the scenario. The "
            "clocks of the participants are spread evenly over +-250 ms and run fast or slow "
            "by 50 ppm. Takes the options above, at most 16 participants and one seed "
            "only. With paper each viewer draws 35 frames a second, and a sample is of its newest. "
            "With --external-clocks-ms each program is given such a clock; otherwise none has "
            "one, whatever the computer has. The scenarios step and partition change after 30 s, "
            "so that "
            "they need 28 actions or more. Every figure is from what the logs of the programs "
            "say that they showed, on the machine's CLOCK_MONOTONIC; but the limit is that of "
            "the delays which the scenario has then. Prints the keys above, and besides or "
            "otherwise:",
        .options = {drift_option::kOfLive.begin(), drift_option::kOfLive.end()},
        .schema = drift_key::kSchema,
        .keys = {drift_key::kLive, drift_key::kNetwork, drift_key::kBound, drift_key::kLostBound,
                 drift_key::kVirtual, drift_key::kVirtualShown, drift_key::kIsWithinBound,
                 drift_key::kIsEndStateSame, drift_key::kHandshakeMean, drift_key::kHandshakeMax,
                 drift_key::kSampleGap, drift_key::kLoad, drift_key::kLoopbackMedian,
                 drift_key::kLoopbackP95, drift_key::kLiveBytes, drift_key::kLiveProbes,
                 drift_key::kLiveAccessLink}};
}

Use driftTables()
{
    Use use{
        .lines = {"--live --table [OPTION...] [--netlab PROGRAM] [--warm-up-s T]"},
        .text =
            "Runs in real time, one after the other, for a table: the scenarios lan, metro, wan "
            "and paper with the strategies event, asa-fixed, asa-adaptive, session-clock and "
            "local-lag and with 2 and 6 participants, 40 runs. --scenario, --strategy and "
            "--participants choose one of them or another. 12 actions and 15 s of warm-up unless "
            "given, which take 22 minutes. Other programs on the same processor are part of what "
            "is measured: start it with a high priority, which its programs inherit. Which run it "
            "is at is reported on stderr. Prints:",
        .options = {drift_option::kOfTable.begin(), drift_option::kOfTable.end()},
        .schema = drift_key::kTableSchema,
        .keys = {drift_key::kNetwork, drift_key::kTurningSpeed, drift_key::kMovingSpeed,
                 drift_key::kActions, drift_key::kWarmUpTime, drift_key::kExternalClocks,
                 drift_key::kLocalLag, drift_key::kAsaDelays, drift_key::kSeed, drift_key::kMet,
                 drift_key::kMissed, drift_key::kRows}};
    for (Key key : keysOfRow()) {
        key.depth = 1;
        use.keys.push_back(key);
    }
    Key error = drift_key::kRowError;
    error.depth = 1;
    use.keys.push_back(error);
    return use;
}

Result<QJsonObject> drift(const Words& words)
{
    return isTable(words) ? driftTable(words) : driftRequest(words).and_then(measuredDrift);
}

} // namespace

Command driftCommand()
{
    return {.name = "drift",
            .theme = "drift and network",
            .summary = "measures the drift between the views of shared objects",
            .uses = {driftInVirtualTime(), driftInRealTime(), driftTables()},
            .experiment = drift};
}

} // namespace carina::lab
