#pragma once

#include "apps/lab/command/command.h"

#include <array>

namespace carina::lab
{

// Options of `drift`, and the keys of what it prints.

namespace drift_option
{
inline constexpr Option kScenario{
    "scenario", "NAME|FILE",
    "the network: lan, wifi, metro, wan, asymmetric, cellular, 5g, starlink, step, partition, "
    "burst, bottleneck, duplication, reordering, clock or paper, which also draws the views at 35 "
    "Hz (docs/synchronisation.md); or a file of lines \"t_ms delay_ms\", with x as the delay of "
    "what is lost, which is repeated"};
inline constexpr Option kStrategy{
    "strategy", "S",
    "session-clock (unless given), local-lag, asa-adaptive, asa-fixed, dead-reckoning, "
    "interpolation, event or none"};
inline constexpr Option kParticipants{"participants", "N", "2 to 64; 2 unless given"};
inline constexpr Option kTurningSpeed{"speed-deg-s", "W",
                                      "of the turned object, above 0, at most 1000; 100 unless "
                                      "given"};
inline constexpr Option kMovingSpeed{"speed-mm-s", "V",
                                     "of the moved object, 0 to 10000; 100 unless given"};
inline constexpr Option kActions{"actions", "A", "1 to 10000; 50 unless given, with --live 15"};
inline constexpr Option kAxes{
    "axes", "AXES",
    "cartesian (unless given), where each axis is one of +-x, +-y and +-z, or random, where it is "
    "any"};
inline constexpr Option kExternalClocks{
    "external-clocks-ms", "E",
    "every program has a clock beside its own that is disciplined from outside, by NTP or PTP, and "
    "off by a constant of at most E, above 0, at most 1000; none unless given"};
inline constexpr Option kLocalLag{"local-lag-ms", "L",
                                  "bound of the lag of local-lag, 0 to 100; 16 unless given"};
inline constexpr Option kAsaDelays{
    "asa-delays", "P",
    "how many delays the history of the ASA holds, 2 to 1000; as published 100, unless given, and "
    "10 in a table, where the ASA is to adapt before the first action"};
inline constexpr Option kSeed{"seed", "K", "of the run, 0 to 4294967295; 1 unless given"};
inline constexpr Option kSeeds{
    "seeds", "M", "how many runs, with the seeds K, K+1 and so on, 1 to 1000; 1 unless given"};
inline constexpr Option kLive{"live", "", "runs real programs in real time"};
inline constexpr Option kNetlab{"netlab", "PROGRAM",
                                "the network emulator to use in place of the relays; only as root"};
inline constexpr Option kWarmUp{
    "warm-up-s", "T",
    "seconds for the clocks to settle before the first action, 0 to 300; 20 unless given"};
inline constexpr Option kLogs{"logs", "DIR",
                              "folder for the log of each program; it is created if missing"};
inline constexpr Option kTable{"table", "", "measures one run after the other for a table of them"};

inline constexpr std::array kOfAll{kScenario,    kStrategy,  kParticipants, kTurningSpeed,
                                   kMovingSpeed, kActions,   kAxes,         kExternalClocks,
                                   kLocalLag,    kAsaDelays, kSeed,         kSeeds};
inline constexpr std::array kOfLive{kLive, kNetlab, kWarmUp, kLogs};
inline constexpr std::array kOfTable{kTable};
} // namespace drift_option

namespace drift_key
{
inline constexpr Key kSchema{"schema", "carina.drift/1"};
inline constexpr Key kStrategy{"strategy", "as given"};
inline constexpr Key kParticipants{"participants", "as given"};
inline constexpr Key kTurningSpeed{"speed_deg_s", "as given"};
inline constexpr Key kMovingSpeed{"speed_mm_s", "as given"};
inline constexpr Key kActions{"actions", "as given"};
inline constexpr Key kActionTime{"action_s", "duration of an action"};
inline constexpr Key kAxes{"axes", "as given"};
inline constexpr Key kScenario{"scenario", "its name"};
inline constexpr Key kExternalClocks{"external_clocks_ms", "as given; null where there are none"};
inline constexpr Key kLocalLag{"local_lag_ms", "as given: the bound, which local-lag alone uses"};
inline constexpr Key kAsaDelays{"asa_delays", "as given: of the history, which the ASA alone has"};
inline constexpr Key kSeed{"seed", "as given"};
inline constexpr Key kSeeds{"seeds", "as given"};
inline constexpr Key kAtEvent{"at_event_mean_deg",
                              "mean angle between truth and view just before the next action"};
inline constexpr Key kRawAtLast{
    "raw_at_last_event_deg",
    "2 acos(w) of the two orientations at the end of the last action, mean over the runs, as the "
    "2004 paper has it: where the signs of the two quaternions differ, 360 less the angle"};
inline constexpr Key kRawGreatest{"raw_greatest_deg", "the greatest of these means of an action"};
inline constexpr Key kTimeAverage{"time_average_mean_deg", "mean of that angle over time"};
inline constexpr Key kPercentile{"p95_deg", "95th percentile over time of that angle, of each run"};
inline constexpr Key kLost{
    "lost_actions",
    "actions of the turned object that a viewer did not show by their end, of all viewers; mean "
    "over the runs"};
inline constexpr Key kShown{
    "time_average_shown_deg",
    "time average without the lost actions and those that follow one; null where none is left"};
inline constexpr Key kPosition{"position_mean_mm",
                               "mean distance of the moved object from the truth, over time"};
inline constexpr Key kLimit{
    "limit_time_average_deg",
    "time average that no strategy can be below with the delays of the run whose actor does not "
    "wait, as with local-lag, and whose viewers go on with the old motion until they hear; the "
    "asymmetry of a path, which no two clocks can see, is not in it"};
inline constexpr Key kRatio{"ratio_to_limit", "time average to that; null where the limit is 0"};
inline constexpr Key kResponse{"response_ms",
                               "mean time from an action to its beginning in its actor's own view"};
inline constexpr Key kClockError{
    "clock_error_ms",
    "mean |session clock - clock of the host|; null where there is no session clock"};
inline constexpr Key kBytes{"bytes_per_s",
                            "mean of the payload that a participant sends and receives"};
inline constexpr Key kProbes{
    "probes_per_s", "datagrams sent to measure the delay and nothing else, of all together"};
inline constexpr Key kAccessLink{"access_link",
                                 "these figures again, with the delay of the scenario on each link "
                                 "to the host, so that the path from actor to viewer has it twice"};

// Of a live run besides, or instead.
inline constexpr Key kLive{"live", "true"};
inline constexpr Key kNetwork{"network", "relay or netlab"};
inline constexpr Key kBound{
    "bound_time_average_deg",
    "1.25 of virtual time + W 0.3 ms; with session-clock also 1.5 limit + W (0.2 ms + half the "
    "asymmetry of the paths, or E if that is less, + half a frame), if that is less"};
inline constexpr Key kVirtual{
    "virtual_time_average_deg",
    "time_average_mean_deg of the same in virtual time, mean of twenty runs"};
inline constexpr Key kVirtualShown{"virtual_time_average_shown_deg",
                                   "the same of time_average_shown_deg"};
inline constexpr Key kLostBound{
    "bound_lost_actions",
    "those of virtual time and three times their square root; in a scenario that loses messages, "
    "and with a strategy that does not repeat them, one action more, by all viewers"};
inline constexpr Key kIsWithinBound{
    "is_within_bound",
    "whether the time average, but for session-clock and local-lag that of the actions that were "
    "shown, and the lost actions are at most these"};
inline constexpr Key kIsEndStateSame{
    "is_end_state_same",
    "whether the final poses of both objects are equal in all programs, bit for bit"};
inline constexpr Key kHandshakeMean{"handshake_mean_ms",
                                    "until a participant was in and had the session's clock"};
inline constexpr Key kHandshakeMax{"handshake_max_ms", "the longest of these"};
inline constexpr Key kSampleGap{
    "sample_gap_p95_ms",
    "95th percentile of the time between samples of a program, which is to be 5.003 ms"};
inline constexpr Key kLoad{"load_average", "of the machine, in the minute in which the run ended"};
inline constexpr Key kLoopbackMedian{
    "loopback_round_trip_median_ms",
    "of a datagram from one thread of this computer to another and back, before the run: what is "
    "less than the computer itself takes cannot be measured on it"};
inline constexpr Key kLoopbackP95{"loopback_round_trip_p95_ms", "95th percentile of the same"};
inline constexpr Key kLiveBytes{"bytes_per_s",
                                "the same of the encrypted datagrams; null with --netlab"};
inline constexpr Key kLiveProbes{"probes_per_s", "null"};
inline constexpr Key kLiveAccessLink{"access_link", "null"};

// Of a table.
inline constexpr Key kTableSchema{"schema", "carina.drift-table/1"};
inline constexpr Key kWarmUpTime{"warm_up_s", "as given"};
inline constexpr Key kRows{"rows", "one object for each run, with the keys of a run:"};
inline constexpr Key kRowError{"error", "why there are no figures, where a run has failed"};
inline constexpr Key kMet{"met", "rows that are within their bound"};
inline constexpr Key kMissed{"missed", "rows that are not, or have failed"};
} // namespace drift_key

} // namespace carina::lab
