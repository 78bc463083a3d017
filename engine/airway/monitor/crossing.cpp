#include "engine/airway/monitor/crossing.h"

namespace carina
{
namespace
{

Length interpolated(Length a, Length b, double share) { return a + share * (b - a); }

TipReading interpolated(const TipReading& a, const TipReading& b, double share)
{
    return {.at = a.at + fromSeconds(share * toSeconds(b.at - a.at)),
            .depthAtTeeth = interpolated(a.depthAtTeeth, b.depthAtTeeth, share),
            .aboveCarina = interpolated(a.aboveCarina, b.aboveCarina, share),
            .besides = interpolated(a.besides, b.besides, share)};
}

} // namespace

std::optional<Passage> Crossing::take(double newest, const TipReading& reading,
                                      const CrossingRule& rule)
{
    const double sign = isIn ? -1.0 : 1.0;
    const double past = sign * newest; // above 0: on the other side
    if (past <= 0.0) {
        begun.reset();
        beyond.reset();
    } else if (!begun) {
        const double before = value ? sign * *value : 0.0;
        begun = Passage{.reading = value ? interpolated(latest, reading, -before / (past - before))
                                         : reading,
                        .isIn = !isIn,
                        .wasUnseen = !value || reading.at - latest.at > kUnseen};
    }
    value = newest;
    latest = reading;
    if (past <= rule.band) {
        beyond.reset();
        return std::nullopt;
    }
    const bool isSecond = beyond.has_value();
    beyond = beyond.value_or(reading.at);
    const bool isSure = isSecond && past > rule.sure && !(isIn && rule.keepsIn);
    if (!isSure && (!isSecond || reading.at - *beyond < (isIn ? rule.dwellOut : rule.dwellIn)))
        return std::nullopt;
    Passage passage = *begun;
    passage.beyond = past;
    isIn = !isIn;
    begun.reset();
    beyond.reset();
    return passage;
}

} // namespace carina
