#pragma once

#include "apps/lab/command/command.h"

namespace carina::lab
{

// Options of `intubate`, and the keys of what its three ways print.

namespace intubate_option
{
inline constexpr Option kTube{
    "tube", "MM",
    "inner diameter of the tube, 2.5 to 9; the patient's usual one unless "
    "given"};
inline constexpr Option kElastic{
    "elastic", "",
    "the hands move a tube that bends between the walls of the airway, and not a rigid one that "
    "passes through them; the monitor is shown a rod"};
inline constexpr Option kSeed{"seed", "N",
                              "of the motion, tracker and registration; 1 unless given"};
inline constexpr Option kRegistration{
    "registration", "MM",
    "error of the registration at the carina, root mean square, 0 to 20, and 1 degree for each "
    "1.5 mm about it; 1.5 unless given"};
inline constexpr Option kSave{"save", "FILE",
                              "write the observed poses as a recording, in the form of the "
                              "extension: .csv or .igs.mha, with the times from the start"};
inline constexpr Option kSite{"site", "FILE",
                              "the site at which it was recorded: its registration, and its tube "
                              "and laryngoscope where they are calibrated; unless given, the "
                              "tracker measures in the patient's frame, the connector, the blade "
                              "and the mandible themselves, as --save writes them"};
inline constexpr Option kBlade{
    "blade", "NAME",
    "macintosh-0 to macintosh-4, miller-0 to miller-2 or "
    "hyperangulated; unless given that of the site, else the one that "
    "the name of the laryngoscope tells, else one that fits the patient"};
inline constexpr Option kTold{"told", "STEP=S",
                              "what people did beside it, S seconds from its beginning", true};
inline constexpr Option kAll{"all-scripts", "", "runs each motion several times"};
inline constexpr Option kSeeds{"seeds", "N", "how often: with the seeds 1 to N, 20 unless given"};
} // namespace intubate_option

namespace intubate_key
{
inline constexpr Key kSchema{"schema", "carina.intubate/1"};
inline constexpr Key kPatient{"patient", "who is intubated"};
inline constexpr Key kTube{"tube_mm", "inner diameter of the tube"};
inline constexpr Key kShape{
    "tube", "how the monitor was shown it: rod, elastic in the patient's lumen, where it was "
            "calibrated, and with --elastic; else rigid"};
inline constexpr Key kScript{"script", "the motion"};
inline constexpr Key kSeed{"seed", "its seed"};
inline constexpr Key kOutside{"outside",
                              "the parameter that is beyond its usual range; null where none is"};
inline constexpr Key kOutcome{"outcome",
                              "where the monitor sees the tip in the end: none, trachea, "
                              "right_main, left_main or oesophagus"};
inline constexpr Key kConfidence{"confidence", "in that, 0 to 1"};
inline constexpr Key kIsRight{"right", "whether it truly is there"};
inline constexpr Key kAttempts{"attempts", "how often the blade went in, by the monitor"};
inline constexpr Key kDepth{
    "depth_at_teeth_mm", "of the tip in the end, by the monitor; null where it is frozen, as both "
                         "shapes of the tube are apart"};
inline constexpr Key kAboveCarina{"tip_above_carina_mm",
                                  "likewise, along the airway; null in the oesophagus"};
inline constexpr Key kRegistration{"registration_share_mm",
                                   "how far the registration's error moves the tip in the end"};
inline constexpr Key kRegistrationAtTeeth{"registration_at_teeth_mm",
                                          "and the incisors, where the depth is read"};
inline constexpr Key kTruth{"truth", "what happened:"};
inline constexpr Key kTrueOutcome{"outcome", "where the tip is in the end", 1};
inline constexpr Key kTrueAttempts{"attempts", "how often the blade went in", 1};
inline constexpr Key kTrueDepth{"depth_at_teeth_mm", "of the tip in the end", 1};
inline constexpr Key kTrueAboveCarina{"tip_above_carina_mm",
                                      "likewise; null on a way that does not pass the carina", 1};
inline constexpr Key kTrueTimeline{"timeline", "an object each, by time:", 1};
inline constexpr Key kTrueStep{"step", "what happened", 2};
inline constexpr Key kTrueAt{"at_s", "from the start", 2};
inline constexpr Key kTimeline{"timeline", "what the monitor noted, by time:"};
inline constexpr Key kStep{"step", "what happened", 1};
inline constexpr Key kAt{"at_s", "from the start", 1};
inline constexpr Key kNotedAt{"noted_at_s", "when it was noted", 1};
inline constexpr Key kSeat{"seat", "where the tip is from then on", 1};
inline constexpr Key kStepConfidence{"confidence", "0 to 1", 1};
inline constexpr Key kStepDepth{"depth_at_teeth_mm", "of the tip; null while it is frozen", 1};
inline constexpr Key kStepAboveCarina{"tip_above_carina_mm", "likewise; null in the oesophagus", 1};
inline constexpr Key kVitals{"vitals", "of the patient, every ten seconds:"};
inline constexpr Key kVitalsAt{"at_s", "from the start", 1};
inline constexpr Key kSaturation{"saturation_percent", "of the arterial blood", 1};
inline constexpr Key kShown{"spo2_percent", "as the oximeter shows it; null without its probe", 1};
inline constexpr Key kEndTidal{"etco2_mmhg", "of the last breath; null before the first", 1};
inline constexpr Key kHeartRate{"heart_rate_per_min", "beats", 1};
inline constexpr Key kMean{"mean_pressure_mmhg", "arterial", 1};
inline constexpr Key kMetrics{"metrics", "what was measured of the try:"};
inline constexpr Key kMeasuredMetric{"metric", "its word, as in rubrics, with the unit", 1};
inline constexpr Key kMeasuredValue{"value", "1 is yes", 1};
inline constexpr Key kNotMeasured{"not_measured", "the words of what was not"};
inline constexpr Key kScore{"score", "by the published rubric; null where no try began:"};
inline constexpr Key kRubric{"rubric", "its name", 1};
inline constexpr Key kSource{"source", "where it is published", 1};
inline constexpr Key kPoints{"points", "penalties included", 1};
inline constexpr Key kPossible{"possible", "of what could be judged", 1};
inline constexpr Key kOfAll{"of_all", "of all criteria", 1};
inline constexpr Key kJudgements{"judgements", "an object for each criterion:", 1};
inline constexpr Key kCriterion{"criterion", "its name", 2};
inline constexpr Key kMetric{"metric", "its word", 2};
inline constexpr Key kVerdict{"verdict", "met, missed, never or not_measured", 2};
inline constexpr Key kValue{"value", "null where there is none", 2};
inline constexpr Key kGot{"points", "got", 2};
inline constexpr Key kMoment{"moment_s", "that lost points are linked to; null where none", 2};
} // namespace intubate_key

namespace intubate_recording_key
{
inline constexpr Key kSchema{"schema", "carina.intubate.recording/1"};
inline constexpr Key kRecording{"recording", "RECORDING as given"};
inline constexpr Key kBlade{"blade", "which one the laryngoscope is taken to have"};
} // namespace intubate_recording_key

namespace intubate_all_key
{
inline constexpr Key kSchema{"schema", "carina.intubate.all/1"};
inline constexpr Key kPatient{"patient", "who is intubated"};
inline constexpr Key kTube{"tube_mm", "inner diameter of the tube"};
inline constexpr Key kShape{"tube", "how the monitor was shown it: rod or rigid"};
inline constexpr Key kRuns{"runs", "how many"};
inline constexpr Key kOutside{"runs_outside", "of these, with a parameter beyond its usual range"};
inline constexpr Key kWrong{"wrong_outcomes", "how often the monitor saw the tip elsewhere"};
inline constexpr Key kUnsure{"wrong_and_unsure", "of these, with a confidence below 0.8"};
inline constexpr Key kSurelyRight{"right_and_sure", "right ones with a confidence of at least 0.8"};
inline constexpr Key kConfusion{"confusion", "an object for each true outcome:"};
inline constexpr Key kTruth{"truth", "it", 1};
inline constexpr Key kNone{"none", "how often the monitor saw that", 1};
inline constexpr Key kTrachea{"trachea", "likewise", 1};
inline constexpr Key kRightMain{"right_main", "likewise", 1};
inline constexpr Key kLeftMain{"left_main", "likewise", 1};
inline constexpr Key kOesophagus{"oesophagus", "likewise", 1};
inline constexpr Key kFrozen{"depth_frozen",
                             "runs with the right outcome that tell no depth in the end, as both "
                             "shapes of the tube are apart"};
inline constexpr Key kDepth{"depth",
                            "errors of the depth at the teeth of the others, where the outcome is "
                            "right:"};
inline constexpr Key kCarina{"above_carina",
                             "of the tip's distance from the carina, likewise, in the airway:"};
inline constexpr Key kMedian{"median_mm", "of the magnitude", 1};
inline constexpr Key k95{"p95_mm", "95 % are smaller", 1};
inline constexpr Key kGreatest{"greatest_mm", "the largest", 1};
inline constexpr Key kWithin{"within", "share within 3 mm and what the registration moves the tip",
                             1};
inline constexpr Key kTimes{"times", "errors of the times of passages:"};
inline constexpr Key kMedianTime{"median_ms", "of the magnitude", 1};
inline constexpr Key k95Time{"p95_ms", "95 % are smaller", 1};
inline constexpr Key kGreatestTime{"greatest_ms", "the largest", 1};
inline constexpr Key kWithinTime{"within", "share within 100 ms", 1};
inline constexpr Key kMissed{"missed", "passages that were not noted within a second", 1};
inline constexpr Key kInvented{"invented", "passages noted that were none", 1};
inline constexpr Key kAttempts{"wrong_attempts", "runs in which attempts were miscounted"};
inline constexpr Key kWrongRuns{"wrong", "an object for each wrong outcome:"};
inline constexpr Key kWrongScript{"script", "the motion", 1};
inline constexpr Key kWrongSeed{"seed", "its seed", 1};
inline constexpr Key kWrongTruth{"truth", "where the tip is", 1};
inline constexpr Key kWrongOutcome{"outcome", "where the monitor saw it", 1};
inline constexpr Key kWrongConfidence{"confidence", "in that", 1};
inline constexpr Key kWrongOutside{"outside", "the parameter beyond its range; null: none", 1};
} // namespace intubate_all_key

} // namespace carina::lab
