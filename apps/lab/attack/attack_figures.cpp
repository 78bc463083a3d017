#include "apps/lab/attack/attack_figures.h"

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr double kMostDriftRatio = 2.0;
/// Of what is usual: the noise of a good optical tracker, below which nobody can tell a place from
/// another. In a run that has less, twice of this is as good as twice of nothing.
constexpr double kLeastUsualDrift_mm = 0.1;
constexpr double kMostJoin_s = 2.0;
// By how much the memory of a program varies that draws and is not attacked: seen are 4.8 MB and
// 1.4 MB, of pages that hold blocks of every age.
constexpr double kConsoleVaries_kb = 5120.0;
constexpr double kTraineeVaries_kb = 2048.0;
// Of a fact in the log and in what follows from it, and of an encrypted path.
constexpr double kFact_kb = 1.0;
constexpr double kPath_kb = 64.0;
constexpr double kBytesPerKb = 1024.0;

bool areWithin(const std::vector<std::optional<double>>& memory_kb,
               const std::array<double, 2>& most_kb)
{
    return std::ranges::equal(
        memory_kb, most_kb,
        [](const std::optional<double>& held, double most) { return held && *held <= most; });
}

bool holdsDrift(const AttackFigures& figures)
{
    const ShownPlaces& during = figures.during.places;
    return during.places() > 0
           && during.drift_mm()
                  <= kMostDriftRatio * std::max(kLeastUsualDrift_mm, usualDriftOf_mm(figures));
}

bool holdsJumps(const AttackFigures& figures)
{
    return figures.during.places.jumps() <= mostJumpsOf(figures);
}

bool holdsGap(const AttackFigures& figures)
{
    return toSeconds(figures.during.largestGap) * 1e3 <= kMostGap_ms;
}

bool letsIn(const AttackFigures& figures)
{
    return !figures.joined.empty() && std::ranges::all_of(figures.joined, [](const auto& joined) {
        return joined.second && toSeconds(*joined.second) <= kMostJoin_s;
    });
}

} // namespace

double usualDriftOf_mm(const AttackFigures& figures)
{
    return figures.usual.driftAtPhasesOf_mm(figures.during.places);
}

std::int64_t mostJumpsOf(const AttackFigures& figures) { return figures.patientsLaid; }

double mostFactsOf(const AttackFigures& figures)
{
    return figures.kind->mostFacts + figures.kind->factsPerS * toSeconds(figures.length);
}

double leastFactsOf(const AttackFigures& figures)
{
    // Each newcomer's joining, too.
    return double(figures.joined.size()) + figures.kind->leastPerS * toSeconds(figures.length);
}

/// Only the host of a session has paths.
std::array<double, 2> mostMemoryOf_kb(const AttackFigures& figures)
{
    const double facts = kFact_kb * double(figures.facts);
    // What the host has ended, the attacker may not know yet.
    const double paths = std::min(double(figures.paths), figures.kind->mostPaths);
    return {kConsoleVaries_kb + facts + kPath_kb * paths, kTraineeVaries_kb + facts};
}

double leastLeakOf_bytes(const AttackFigures& figures)
{
    const auto sent = static_cast<double>(std::max<std::int64_t>(1, figures.sent));
    return kBytesPerKb * mostMemoryOf_kb(figures)[0] / sent;
}

bool holdsOwn(const AttackFigures& figures)
{
    const auto facts = static_cast<double>(figures.facts);
    return double(figures.sent) >= figures.kind->leastSent && facts >= leastFactsOf(figures)
           && facts <= mostFactsOf(figures)
           && std::ranges::all_of(figures.measured, [](const Measured& own) {
                  return own.figure >= own.least && own.figure <= own.most;
              });
}

bool holdsMemory(const AttackFigures& figures)
{
    const std::array most_kb = mostMemoryOf_kb(figures);
    return areWithin(figures.memory_kb, most_kb) || areWithin(figures.memoryAgain_kb, most_kb);
}

bool holds(const AttackFigures& figures)
{
    return !figures.isTakenForAnother && figures.putOut == 0 && figures.moved == 0
           && holdsGap(figures) && holdsDrift(figures) && holdsJumps(figures) && letsIn(figures)
           && holdsOwn(figures) && holdsMemory(figures);
}

} // namespace carina::lab
