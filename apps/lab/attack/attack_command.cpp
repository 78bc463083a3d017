#include "apps/lab/attack/attack_experiment.h"
#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "engine/net/entry/psk_identity.h"

#include <QJsonArray>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace carina::lab
{
namespace
{

namespace attack_option
{
constexpr Option kSeconds{
    "seconds", "S",
    "how long each attack at least, 4 to 600; 10 unless given. One that is to send many datagrams "
    "goes on until it has, 120 s at most"};
constexpr Option kOnly{"only", "NAMES",
                       "these attacks, in this order: names as above, with commas between them; "
                       "all once unless given"};
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
constexpr Key kLasted{"lasted_s", "how long it was", 1};
constexpr Key kSent{"sent",
                    "datagrams that the attacker sent over its paths, paths that came to be "
                    "encrypted, ClientHellos, or tokens that the host refused",
                    1};
constexpr Key kLeastSent{"least_sent", "without which it was no such attack", 1};
constexpr Key kTaken{"taken_for_another",
                     "whether the host took the attacker for another participant; never", 1};
constexpr Key kGapBefore{"largest_gap_before_ms",
                         "between two samples of the trainee's tube at an observer, in as much "
                         "time before the attack",
                         1};
constexpr Key kGap{"largest_gap_ms", "the same during the attack", 1};
constexpr Key kMostGap{"most_gap_ms", "that may be, with guests too", 1};
constexpr Key kLate{"late_look_ms",
                    "the longest time in it for which the observer's own thread did not run, where "
                    "the processor was busy: as much of the gap may not be the session's",
                    1};
constexpr Key kUsualDrift{
    "usual_drift_mm",
    "root mean square of how far the tube was shown there from where it was, "
    "before anybody attacked, at the phases of its motion that the attack saw",
    1};
constexpr Key kDrift{
    "drift_mm", "the same during the attack; at most twice the usual, of which at least 0.1 counts",
    1};
constexpr Key kJumps{"jumps",
                     "how often the tube was elsewhere from one sample to the next during the "
                     "attack, as when the trainee lays another patient; the drift until the view "
                     "has followed is left out",
                     1};
constexpr Key kMostJumps{
    "most_jumps", "that may be: the patients that were laid because the attacker chose them", 1};
constexpr Key kJoin{"join_s",
                    "how long a newcomer of each role took to come in meanwhile, one after "
                    "another, without the derivation of their keys; at most 2; null: not within 10",
                    1};
constexpr Key kPutOut{"put_out",
                      "of those who only take part, guests included, how many were not present "
                      "throughout; 0",
                      1};
constexpr Key kMoved{"moved",
                     "objects that the observer is shown elsewhere than before the attack, or "
                     "moved where nobody had moved them; 0",
                     1};
constexpr Key kMeasured{"measured", "what the attack measured by itself, one object each:", 1};
constexpr Key kMeasuredWhat{"what", "of what", 2};
constexpr Key kMeasuredFigure{"figure", "during the attack", 2};
constexpr Key kMeasuredLeast{"least", "without which it was no such attack", 2};
constexpr Key kMeasuredMost{"most", "that may be; null: no bound", 2};
constexpr Key kFacts{"facts", "by which the log is longer afterwards", 1};
constexpr Key kLeastFacts{"least_facts", "without which it was no such attack", 1};
constexpr Key kMostFacts{"most_facts", "that may come of it", 1};
constexpr Key kPaths{"paths",
                     "encrypted paths that the attacker had, at most at once, over which nobody "
                     "came in; of these the host keeps 64 for the code of a role",
                     1};
constexpr Key kMemory{
    "memory_kb",
    "by which the least that console and trainee hold in the 3 to 25 s after it is more than "
    "before it; null: not measured, which does not hold",
    1};
constexpr Key kMemoryAgain{
    "memory_again_kb",
    "the same of a second attack of this kind, which is begun where the first left more than "
    "may be and counts in its stead; [] where none was, or it was weaker",
    1};
constexpr Key kMostMemory{"most_memory_kb",
                          "that may come of it: what programs that draw vary by, 1 for each of "
                          "`facts`, and at the console 64 for each of `paths`",
                          1};
constexpr Key kLeastLeak{"least_leak_bytes",
                         "the least that the console would have to keep of each of `sent` to "
                         "exceed that",
                         1};
constexpr Key kHolds{"holds", "whether all of these are within their bounds", 1};
} // namespace attack_key

double inMilliseconds(Duration duration) { return toSeconds(duration) * 1e3; }

QJsonValue orNull(const std::optional<double>& number)
{
    return number && std::isfinite(*number) ? QJsonValue{*number} : QJsonValue::Null;
}

QJsonArray arrayOf(const auto& numbers)
{
    QJsonArray array;
    for (const std::optional<double> each : numbers)
        array.append(orNull(each));
    return array;
}

QJsonObject joinsOf(const AttackFigures& figures)
{
    QJsonObject joins;
    for (const auto& [role, joined] : figures.joined) {
        const std::string_view word = roleWord(role);
        joins[QLatin1StringView{word.data(), qsizetype(word.size())}] =
            orNull(joined ? std::optional{toSeconds(*joined)} : std::nullopt);
    }
    return joins;
}

QJsonArray measuredOf(const AttackFigures& figures)
{
    QJsonArray all;
    for (const Measured& own : figures.measured)
        all.append(QJsonObject{{attack_key::kMeasuredWhat, QLatin1StringView{own.what}},
                               {attack_key::kMeasuredFigure, own.figure},
                               {attack_key::kMeasuredLeast, own.least},
                               {attack_key::kMeasuredMost, orNull(own.most)}});
    return all;
}

QJsonObject objectOf(const AttackFigures& figures)
{
    return {{attack_key::kName, QLatin1StringView{figures.kind->name}},
            {attack_key::kLasted, toSeconds(figures.length)},
            {attack_key::kSent, qint64{figures.sent}},
            {attack_key::kLeastSent, figures.kind->leastSent},
            {attack_key::kTaken, figures.isTakenForAnother},
            {attack_key::kGapBefore, inMilliseconds(figures.before.largestGap)},
            {attack_key::kGap, inMilliseconds(figures.during.largestGap)},
            {attack_key::kMostGap, kMostGap_ms},
            {attack_key::kLate, inMilliseconds(figures.during.latest)},
            {attack_key::kUsualDrift, usualDriftOf_mm(figures)},
            {attack_key::kDrift, figures.during.places.drift_mm()},
            {attack_key::kJumps, figures.during.places.jumps()},
            {attack_key::kMostJumps, qint64{mostJumpsOf(figures)}},
            {attack_key::kJoin, joinsOf(figures)},
            {attack_key::kPutOut, qint64{figures.putOut}},
            {attack_key::kMoved, qint64{figures.moved}},
            {attack_key::kMeasured, measuredOf(figures)},
            {attack_key::kFacts, qint64{figures.facts}},
            {attack_key::kLeastFacts, leastFactsOf(figures)},
            {attack_key::kMostFacts, mostFactsOf(figures)},
            {attack_key::kPaths, qint64{figures.paths}},
            {attack_key::kMemory, arrayOf(figures.memory_kb)},
            {attack_key::kMemoryAgain, arrayOf(figures.memoryAgain_kb)},
            {attack_key::kMostMemory, arrayOf(mostMemoryOf_kb(figures))},
            {attack_key::kLeastLeak, leastLeakOf_bytes(figures)},
            {attack_key::kHolds, holds(figures)}};
}

Result<std::vector<const AttackKind*>> kindsIn(const Words& words)
{
    std::vector<const AttackKind*> all;
    QStringList names;
    for (const AttackKind& kind : attackKinds()) {
        all.push_back(&kind);
        names += QString::fromLatin1(kind.name);
    }
    if (!words.has(attack_option::kOnly))
        return all;
    std::vector<const AttackKind*> chosen;
    for (const QString& name : words.text(attack_option::kOnly).split(QLatin1Char{','})) {
        const qsizetype index = names.indexOf(name);
        if (index < 0)
            return words.unknownWord(attack_option::kOnly, names);
        chosen.push_back(all[std::size_t(index)]);
    }
    return chosen;
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
    const auto kinds = kindsIn(words);
    if (!kinds)
        return tl::unexpected(kinds.error());
    settings.kinds = *kinds;
    std::fprintf(stderr, "attack: waiting for the programs\n");
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
                attacks.append(objectOf(figures));
            const bool allHold = std::ranges::all_of(all, holds);
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
                  .text =
                      "Starts a console and a trainee in a session of their own, and attacks "
                      "it as one who knows a code could, in one way after another. Meanwhile "
                      "an observer watches the trainee's tube, and a newcomer of each role joins. "
                      "Needs a display. Progress is reported on stderr. The attacks:",
                  .notes = attackNotes(),
                  .options = {attack_option::kSeconds, attack_option::kOnly, attack_option::kGuests,
                              attack_option::kPrograms},
                  .schema = attack_key::kSchema,
                  .keys = {attack_key::kSeconds,       attack_key::kGuests,
                           attack_key::kAttacks,       attack_key::kName,
                           attack_key::kLasted,        attack_key::kSent,
                           attack_key::kLeastSent,     attack_key::kTaken,
                           attack_key::kGapBefore,     attack_key::kGap,
                           attack_key::kMostGap,       attack_key::kLate,
                           attack_key::kUsualDrift,    attack_key::kDrift,
                           attack_key::kJumps,         attack_key::kMostJumps,
                           attack_key::kJoin,          attack_key::kPutOut,
                           attack_key::kMoved,         attack_key::kMeasured,
                           attack_key::kMeasuredWhat,  attack_key::kMeasuredFigure,
                           attack_key::kMeasuredLeast, attack_key::kMeasuredMost,
                           attack_key::kFacts,         attack_key::kLeastFacts,
                           attack_key::kMostFacts,     attack_key::kPaths,
                           attack_key::kMemory,        attack_key::kMemoryAgain,
                           attack_key::kMostMemory,    attack_key::kLeastLeak,
                           attack_key::kHolds,         kAcceptable}}},
        .experiment = runAttacks};
}

} // namespace carina::lab
