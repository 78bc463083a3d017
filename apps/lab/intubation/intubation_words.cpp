#include "apps/lab/intubation/intubation_words.h"

#include "apps/lab/intubation/watched_intubation.h"

#include <QStringList>

#include <algorithm>
#include <array>

namespace carina::lab
{
namespace
{

constexpr std::array kSeatWords{"none", "trachea", "right_main", "left_main", "oesophagus"};
static_assert(kSeatWords.size() == kTubeSeats.size());

constexpr std::array kStepWords{"blade_in",         "blade_out",         "glottis_seen",
                                "tube_past_teeth",  "tube_out",          "through_cords",
                                "back_above_cords", "in_oesophagus",     "out_of_oesophagus",
                                "past_carina",      "back_above_carina", "cuff_inflated",
                                "cuff_deflated",    "stylet_out",        "first_breath",
                                "shapes_apart",     "shapes_together",   "passed_shut",
                                "at_rest"};
static_assert(kStepWords.size() == static_cast<std::size_t>(kLastIntubationStep) + 1);

} // namespace

QString seatWord(TubeSeat seat)
{
    return QString::fromLatin1(kSeatWords[static_cast<std::size_t>(seat)]);
}

QString stepWord(IntubationStep step)
{
    return QString::fromLatin1(kStepWords[static_cast<std::size_t>(step)]);
}

QString toldWord(MotionAct act)
{
    const auto step = toldBy(act);
    return step ? stepWord(*step) : QStringLiteral("breaths_end");
}

QString toldWords()
{
    QStringList words;
    for (const MotionAct act : kToldActs)
        words += toldWord(act);
    return words.join(QLatin1StringView{", "});
}

QString motionWord(MotionKind kind)
{
    const auto* named = std::ranges::find(kNamedMotions, kind, &NamedMotion::kind);
    return QString::fromLatin1(named->name.data(), qsizetype(named->name.size()));
}

} // namespace carina::lab
