#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/soak/soak_experiment.h"

#include <QJsonArray>

#include <algorithm>

namespace carina::lab
{
namespace
{

namespace soak_option
{
constexpr Option kMinutes{"minutes", "T", "how long, 1 to 1440; 60 unless given"};
constexpr Option kPatients{"patients", "N",
                           "changes of the patient in that time, 0 to 10000; 200 unless given"};
constexpr Option kJoins{"joins", "N",
                        "how often an observer comes and goes, 0 to 10000; 200 unless given"};
constexpr Option kEvents{"events", "N",
                         "changes of the breathing and pauses, 0 to 100000; 600 unless given"};
constexpr Option kPrograms{"programs", "DIR",
                           "folder with instructor/carina-instructor and trainee/carina-trainee; "
                           "those built with this program unless given"};
constexpr Option kLimit{"limit-kb-per-min", "K",
                        "memory by which a program may grow beside the log, 0 to 100000; 60 "
                        "unless given"};
} // namespace soak_option

namespace soak_key
{
constexpr Key kSchema{"schema", "carina.soak/1"};
constexpr Key kMinutes{"minutes", "as given; the first tenth is not measured"};
constexpr Key kPatients{"patients", "changes of the patient that were proposed"};
constexpr Key kJoins{"joins", "times that the observer was admitted"};
constexpr Key kEvents{"events", "changes of the breathing and pauses that were proposed"};
constexpr Key kUnanswered{"unanswered", "proposals that were not facts at the end"};
constexpr Key kFacts{"facts", "in the log at the end; all stay in memory"};
constexpr Key kFactsPerMinute{"facts_per_min", "slope of the line through their number"};
constexpr Key kPrograms{"programs", "one object each for console and trainee:"};
constexpr Key kName{"name", "of the program", 1};
constexpr Key kMemory{"memory_kb", "resident memory that is not of a file:", 1};
constexpr Key kPerFact{"bytes_per_fact",
                       "that the log takes in the memory of such a program, with the state that "
                       "follows from it: counted at the end by making both once more",
                       1};
constexpr Key kBesideLog{"beside_log_kb_per_min",
                         "slope of memory less that of the log's: bytes_per_fact times "
                         "facts_per_min. What is judged",
                         1};
constexpr Key kDescriptors{"descriptors", "open file descriptors, likewise", 1};
constexpr Key kThreads{"threads", "likewise", 1};
constexpr Key kFirst{"first", "when measuring began", 2};
constexpr Key kLast{"last", "at the end", 2};
constexpr Key kMost{"most", "in between", 2};
constexpr Key kSlope{
    "per_min",
    "slope of the line through all, by least squares; that of memory through the "
    "least of each twentieth of the time, because what a patient takes while it is "
    "made is given back",
    2};
constexpr Key kError{"per_min_se",
                     "standard error of the slope, for figures of which those close "
                     "in time are alike",
                     2};
} // namespace soak_key

/// Standard errors by which a slope must lie below its limit to be called level: one that is not
/// known well enough is not acceptable.
constexpr double kSignificant = 2.0;
constexpr double kMostPerMinute = 0.05; ///< descriptors or threads: three in an hour
constexpr int kParts = 20;              ///< of the time, of each of which the least memory counts

Trend trendOfMemory(const SoakedProgram& program)
{
    return trendOf(leastOfEach(program.memory_kb, kParts));
}

/// What the log takes in a minute.
double log_kb_per_min(const SoakedProgram& program, const Trend& facts)
{
    constexpr double kBytes = 1024.0;
    return program.bytesPerFact * facts.slope / kBytes;
}

QJsonObject courseOf(const std::vector<TimedFigure>& figures, const Trend& trend)
{
    const auto most = std::ranges::max(figures, {}, &TimedFigure::figure).figure;
    return {{soak_key::kFirst, figures.front().figure},
            {soak_key::kLast, figures.back().figure},
            {soak_key::kMost, most},
            {soak_key::kSlope, trend.slope},
            {soak_key::kError, trend.standardError}};
}

bool staysBelow(const Trend& trend, double limit)
{
    return trend.slope + kSignificant * trend.standardError < limit;
}

bool isLevel(const SoakedProgram& program, const Trend& facts, double limit_kb_per_min)
{
    return staysBelow(trendOfMemory(program), limit_kb_per_min + log_kb_per_min(program, facts))
           && staysBelow(trendOf(program.descriptors), kMostPerMinute)
           && staysBelow(trendOf(program.threads), kMostPerMinute);
}

Result<SoakSettings> settingsOf(const Words& words)
{
    const auto minutes = words.number(soak_option::kMinutes, 1.0, 1440.0, 60.0);
    const auto patients = words.whole(soak_option::kPatients, 0, 10'000, 200);
    const auto joins = words.whole(soak_option::kJoins, 0, 10'000, 200);
    const auto events = words.whole(soak_option::kEvents, 0, 100'000, 600);
    if (!minutes)
        return tl::unexpected(minutes.error());
    for (const auto& count : {patients, joins, events})
        if (!count)
            return tl::unexpected(count.error());
    return SoakSettings{.length = fromSeconds(60.0 * *minutes),
                        .patients = static_cast<int>(*patients),
                        .joins = static_cast<int>(*joins),
                        .events = static_cast<int>(*events),
                        .programs = SessionPrograms::in(words.text(soak_option::kPrograms))};
}

QJsonObject reportOf(const SoakFigures& figures, const SoakSettings& settings, double limit)
{
    QJsonArray programs;
    const Trend facts = trendOf(figures.facts);
    bool isAcceptable = figures.unanswered == 0 && figures.joins == settings.joins;
    for (const SoakedProgram& program : figures.programs) {
        isAcceptable = isAcceptable && isLevel(program, facts, limit);
        const Trend memory = trendOfMemory(program);
        const double besideLog = memory.slope - log_kb_per_min(program, facts);
        programs.append(QJsonObject{
            {soak_key::kName, QString::fromStdString(program.name)},
            {soak_key::kMemory, courseOf(program.memory_kb, memory)},
            {soak_key::kPerFact, program.bytesPerFact},
            {soak_key::kBesideLog, besideLog},
            {soak_key::kDescriptors, courseOf(program.descriptors, trendOf(program.descriptors))},
            {soak_key::kThreads, courseOf(program.threads, trendOf(program.threads))}});
    }
    return {{soak_key::kSchema, QLatin1StringView{soak_key::kSchema.help}},
            {soak_key::kMinutes, toSeconds(settings.length) / 60.0},
            {soak_key::kPatients, figures.patients},
            {soak_key::kJoins, figures.joins},
            {soak_key::kEvents, figures.events},
            {soak_key::kUnanswered, figures.unanswered},
            {soak_key::kFacts, figures.facts.back().figure},
            {soak_key::kFactsPerMinute, facts.slope},
            {soak_key::kPrograms, programs},
            {kAcceptable, isAcceptable}};
}

Result<QJsonObject> runSoak(const Words& words)
{
    const auto limit = words.number(soak_option::kLimit, 0.0, 1e5, 60.0);
    if (!limit)
        return tl::unexpected(limit.error());
    return settingsOf(words).and_then([&](const SoakSettings& settings) {
        return soak(settings).map(
            [&](const SoakFigures& figures) { return reportOf(figures, settings, *limit); });
    });
}

} // namespace

Command soakCommand()
{
    return {
        .name = "soak",
        .theme = "drift and network",
        .summary = "runs console and trainee for long and measures what they hold",
        .uses = {{.lines = {"[--minutes T] [--patients N] [--joins N] [--events N]",
                            "[--programs DIR] [--limit-kb-per-min K]"},
                  .text =
                      "Starts a console and a trainee with a simulated tracker in a session of "
                      "their own, changes the patient and its breathing, lets an observer come "
                      "and go, and samples each second what both programs hold of memory, "
                      "descriptors and threads. The slopes of memory, descriptors and threads plus "
                      "twice their standard errors must stay below their limits: "
                      "--limit-kb-per-min and what the log takes, and 0.05 per minute. Needs a "
                      "display.",
                  .options = {soak_option::kMinutes, soak_option::kPatients, soak_option::kJoins,
                              soak_option::kEvents, soak_option::kPrograms, soak_option::kLimit},
                  .schema = soak_key::kSchema,
                  .keys = {soak_key::kMinutes,        soak_key::kPatients,
                           soak_key::kJoins,          soak_key::kEvents,
                           soak_key::kUnanswered,     soak_key::kFacts,
                           soak_key::kFactsPerMinute, soak_key::kPrograms,
                           soak_key::kName,           soak_key::kMemory,
                           soak_key::kPerFact,        soak_key::kBesideLog,
                           soak_key::kFirst,          soak_key::kLast,
                           soak_key::kMost,           soak_key::kSlope,
                           soak_key::kError,          soak_key::kDescriptors,
                           soak_key::kThreads,        kAcceptable}}},
        .experiment = runSoak};
}

} // namespace carina::lab
