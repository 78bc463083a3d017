#include "apps/lab/attack/attack_experiment.h"
#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"

#include <QJsonArray>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>

namespace carina::lab
{
namespace
{

namespace attack_option
{
constexpr Option kSeconds{"seconds", "S", "how long each attack, 4 to 600; 10 unless given"};
constexpr Option kOnly{"only", "NAME", "one attack: one of the names above; all unless given"};
constexpr Option kGuests{
    "guests", "N", "others who come in before and only take part, 0 to 240; none unless given"};
constexpr Option kPrograms{"programs", "DIR",
                           "folder with instructor/carina-instructor and trainee/carina-trainee; "
                           "those built with this program unless given"};
} // namespace attack_option

namespace attack_key
{
constexpr Key kSchema{"schema", "carina.attack/1"};
constexpr Key kSeconds{"seconds", "as given"};
constexpr Key kGuests{"guests", "as given"};
constexpr Key kAttacks{"attacks", "one object each:"};
constexpr Key kName{"name", "of the attack", 1};
constexpr Key kSent{"sent", "datagrams, handshakes or Hellos of the attacker", 1};
constexpr Key kTaken{"taken_for_another",
                     "whether the host took the attacker for another participant; never", 1};
constexpr Key kGapBefore{"largest_gap_before_ms",
                         "between two samples of the trainee's tube at an observer, in as much "
                         "time before the attack",
                         1};
constexpr Key kGap{"largest_gap_ms", "the same during the attack; at most 100", 1};
constexpr Key kLate{"late_look_ms",
                    "the longest time in it for which the observer's own thread did not run, where "
                    "the processor was busy: as much of the gap may not be the session's",
                    1};
constexpr Key kDriftBefore{"drift_before_mm",
                           "root mean square of how far the tube was shown there from where it "
                           "was, before the attack",
                           1};
constexpr Key kDrift{"drift_mm", "the same during the attack; at most twice that before", 1};
constexpr Key kJumps{"jumps",
                     "how often the tube was elsewhere from one sample to the next during the "
                     "attack, because the trainee laid another patient; the drift until the view "
                     "has followed is left out",
                     1};
constexpr Key kJoin{"join_s",
                    "how long a newcomer took to come in meanwhile, without the derivation of its "
                    "key; at most 2; null: not within 10",
                    1};
constexpr Key kFacts{"facts", "by which the log is longer afterwards", 1};
constexpr Key kMostFacts{"most_facts", "that may come of it", 1};
constexpr Key kMemory{
    "memory_kb",
    "by which the least that console and trainee hold in the 3 to 25 s after it is more than "
    "before it",
    1};
constexpr Key kMostMemory{"most_memory_kb",
                          "that may come of it: what programs that draw vary by, and the facts and "
                          "idle paths that the attack leaves",
                          1};
constexpr Key kHolds{"holds", "whether all of these are within their bounds", 1};
} // namespace attack_key

constexpr double kMostGap_ms = 100.0;
constexpr double kMostDriftRatio = 2.0;
constexpr double kMostJoin_s = 2.0;
// By how much the memory of a program varies that draws and is not attacked: seen are 4.8 MB and
// 1.4 MB, of pages that hold blocks of every age.
constexpr double kConsoleVaries_kb = 5120.0;
constexpr double kTraineeVaries_kb = 2048.0;
// Of a fact in the log and in what follows from it, and of an encrypted path.
constexpr double kFact_kb = 1.0;
constexpr double kPath_kb = 64.0;

double inMilliseconds(Duration duration) { return toSeconds(duration) * 1e3; }

double mostFactsOf(const AttackFigures& figures, Duration length)
{
    return figures.kind->mostFacts + figures.kind->factsPerS * toSeconds(length);
}

/// That of console and trainee. Only the host of a session has paths.
std::array<double, 2> mostMemoryOf_kb(const AttackFigures& figures, Duration length)
{
    const double facts = kFact_kb * mostFactsOf(figures, length);
    return {kConsoleVaries_kb + facts + kPath_kb * figures.kind->mostPaths,
            kTraineeVaries_kb + facts};
}

bool holdsMemory(const AttackFigures& figures, Duration length)
{
    return std::ranges::equal(figures.memory_kb, mostMemoryOf_kb(figures, length),
                              std::less_equal<>{});
}

bool holds(const AttackFigures& figures, Duration length)
{
    return !figures.isTakenForAnother && inMilliseconds(figures.during.largestGap) <= kMostGap_ms
           && figures.during.places.places() > 0
           && figures.during.places.drift_mm() <= kMostDriftRatio * figures.before.places.drift_mm()
           && figures.joined && toSeconds(*figures.joined) <= kMostJoin_s
           && double(figures.facts) <= mostFactsOf(figures, length) && holdsMemory(figures, length);
}

QJsonObject objectOf(const AttackFigures& figures, Duration length)
{
    QJsonArray memory;
    for (const double each : figures.memory_kb)
        memory.append(each);
    QJsonArray mostMemory;
    for (const double each : mostMemoryOf_kb(figures, length))
        mostMemory.append(each);
    return {{attack_key::kName, QLatin1StringView{figures.kind->name}},
            {attack_key::kSent, qint64{figures.sent}},
            {attack_key::kTaken, figures.isTakenForAnother},
            {attack_key::kGapBefore, inMilliseconds(figures.before.largestGap)},
            {attack_key::kGap, inMilliseconds(figures.during.largestGap)},
            {attack_key::kLate, inMilliseconds(figures.during.latest)},
            {attack_key::kDriftBefore, figures.before.places.drift_mm()},
            {attack_key::kDrift, figures.during.places.drift_mm()},
            {attack_key::kJumps, figures.during.places.jumps()},
            {attack_key::kJoin,
             figures.joined ? QJsonValue{toSeconds(*figures.joined)} : QJsonValue::Null},
            {attack_key::kFacts, qint64{figures.facts}},
            {attack_key::kMostFacts, mostFactsOf(figures, length)},
            {attack_key::kMemory, memory},
            {attack_key::kMostMemory, mostMemory},
            {attack_key::kHolds, holds(figures, length)}};
}

Result<AttackSettings> settingsOf(const Words& words)
{
    const auto seconds = words.number(attack_option::kSeconds, 4.0, 600.0, 10.0);
    if (!seconds)
        return tl::unexpected(seconds.error());
    const auto guests = words.whole(attack_option::kGuests, 0, 240, 0);
    if (!guests)
        return tl::unexpected(guests.error());
    AttackSettings settings{.programs = SessionPrograms::in(words.text(attack_option::kPrograms)),
                            .length = fromSeconds(*seconds),
                            .guests = static_cast<int>(*guests)};
    QStringList names;
    for (const AttackKind& kind : attackKinds()) {
        names += QString::fromLatin1(kind.name);
        if (!words.has(attack_option::kOnly) || words.text(attack_option::kOnly) == names.back())
            settings.kinds.push_back(&kind);
    }
    if (settings.kinds.empty())
        return words.unknownWord(attack_option::kOnly, names);
    settings.begins = [count = settings.kinds.size(), begun = 0](const AttackKind& kind) mutable {
        std::fprintf(stderr, "attack: %d of %zu: %s\n", ++begun, count, kind.name);
    };
    return settings;
}

Result<QJsonObject> runAttacks(const Words& words)
{
    return settingsOf(words).and_then([](const AttackSettings& settings) {
        return attackSession(settings).map([&](const std::vector<AttackFigures>& all) {
            QJsonArray attacks;
            for (const AttackFigures& figures : all)
                attacks.append(objectOf(figures, settings.length));
            const bool allHold = std::ranges::all_of(
                all, [&](const AttackFigures& each) { return holds(each, settings.length); });
            return QJsonObject{{attack_key::kSchema, QLatin1StringView{attack_key::kSchema.help}},
                               {attack_key::kSeconds, toSeconds(settings.length)},
                               {attack_key::kGuests, settings.guests},
                               {attack_key::kAttacks, attacks},
                               {kAcceptable, allHold}};
        });
    });
}

std::vector<Note> attackNotes()
{
    std::vector<Note> notes;
    for (const AttackKind& kind : attackKinds())
        notes.push_back({kind.name, kind.what});
    return notes;
}

} // namespace

Command attackCommand()
{
    return {
        .name = "attack",
        .theme = "drift and network",
        .summary = "attacks a session from inside and measures what others notice",
        .uses = {{.lines = {"[--seconds S] [--only NAME] [--guests N] [--programs DIR]"},
                  .text = "Starts a console and a trainee in a session of their own, and attacks "
                          "it as one who knows a code could, in one way after another. Meanwhile "
                          "an observer watches the trainee's tube and a newcomer joins. Needs a "
                          "display. Progress is reported on stderr. The attacks:",
                  .notes = attackNotes(),
                  .options = {attack_option::kSeconds, attack_option::kOnly, attack_option::kGuests,
                              attack_option::kPrograms},
                  .schema = attack_key::kSchema,
                  .keys = {attack_key::kSeconds, attack_key::kGuests, attack_key::kAttacks,
                           attack_key::kName, attack_key::kSent, attack_key::kTaken,
                           attack_key::kGapBefore, attack_key::kGap, attack_key::kLate,
                           attack_key::kDriftBefore, attack_key::kDrift, attack_key::kJumps,
                           attack_key::kJoin, attack_key::kFacts, attack_key::kMostFacts,
                           attack_key::kMemory, attack_key::kMostMemory, attack_key::kHolds,
                           kAcceptable}}},
        .experiment = runAttacks};
}

} // namespace carina::lab
