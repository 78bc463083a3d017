#include "engine/session/fact_rules.h"

#include "engine/session/utf8.h"

#include <array>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <string>

namespace carina
{

namespace
{

std::string inWords(double number)
{
    std::array<char, 32> text{};
    const auto written =
        std::to_chars(text.begin(), text.end(), number, std::chars_format::general, 6);
    return {text.begin(), written.ptr};
}

Result<void> checkNumber(const char* what, double value, double lowest, double highest,
                         const char* unit)
{
    if (!std::isfinite(value))
        return fail(Errc::NotFinite, what);
    if (value < lowest || value > highest)
        return fail(Errc::OutOfRange, std::string{what} + " " + inWords(value) + unit + " ("
                                          + inWords(lowest) + " to " + inWords(highest) + ")");
    return {};
}

Result<void> checkTexts(std::initializer_list<const std::string*> texts)
{
    for (const std::string* text : texts) {
        if (text->size() > kLongestText)
            return fail(Errc::OutOfRange, "a text of " + std::to_string(text->size()) + " bytes ("
                                              + std::to_string(kLongestText) + " at most)");
        if (!isUtf8(*text))
            return fail(Errc::OutOfRange, "a text that is not UTF-8");
    }
    return {};
}

struct BodyCheck {
    Result<void> operator()(const fact::SessionCreated& f) const
    {
        return checkTexts({&f.name, &f.sessionId});
    }
    Result<void> operator()(const fact::PhaseChanged&) const { return {}; }
    Result<void> operator()(const fact::StationAdded& f) const { return checkTexts({&f.name}); }
    Result<void> operator()(const fact::ParticipantJoined& f) const
    {
        return checkTexts({&f.name});
    }
    Result<void> operator()(const fact::ParticipantLeft&) const { return {}; }
    Result<void> operator()(const fact::ObjectShared& f) const { return checkTexts({&f.name}); }
    Result<void> operator()(const fact::ObjectHandedOver&) const { return {}; }
    Result<void> operator()(const fact::ObjectWanted&) const { return {}; }
    Result<void> operator()(const fact::AnatomyChosen& f) const
    {
        return checkTexts({&f.contentHash, &f.name});
    }
    Result<void> operator()(const fact::BreathingRateSet& f) const
    {
        return checkNumber("breathing rate", inPerMinute(f.rate), inPerMinute(kSlowestBreathing),
                           inPerMinute(kFastestBreathing), " /min");
    }
    Result<void> operator()(const fact::TidalVolumeSet& f) const
    {
        return checkNumber("tidal volume", inMillilitres(f.tidalVolume),
                           inMillilitres(kSmallestTidalVolume), inMillilitres(kLargestTidalVolume),
                           " ml");
    }
    Result<void> operator()(const fact::InspiratoryFractionSet& f) const
    {
        return checkNumber("inspiratory fraction", f.fraction, kShortestInspiration,
                           kLongestInspiration, "");
    }
};

} // namespace

Result<void> checkBody(const FactBody& body) { return std::visit(BodyCheck{}, body); }

} // namespace carina
