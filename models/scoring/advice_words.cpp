#include "models/scoring/try_words.h"

#include <QCoreApplication>

namespace carina
{
namespace
{

QString adviceWords(const char* text) { return QCoreApplication::translate("Advice", text); }

} // namespace

QString adviceText(Advice advice)
{
    switch (advice) {
    case Advice::TakeTubeOut:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Look at the capnogram with every breath: without a lasting wave take the "
                      "tube out and ventilate by mask."));
    case Advice::RecogniseSooner:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "The tube was in the oesophagus: doubt it at the first breath "
                      "without a wave of CO2, and never wait for more than seven."));
    case Advice::PullTubeBack:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Stop when the cuff has passed the cords, read the mark at the teeth and "
                      "listen to both sides: the tube lies in one lung."));
    case Advice::VentilateBetween:
        return adviceWords(
            QT_TRANSLATE_NOOP("Advice", "Give oxygen for longer before, and ventilate by mask as "
                                        "soon as the oximeter begins to fall."));
    case Advice::SeeGlottisFirst:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Take the tube only when you see the glottis: lift along the handle until "
                      "the cords come into view."));
    case Advice::ShapeTube:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "You saw the glottis and the tube did not follow: bend it with a stylet, or "
                      "go in with a bougie first."));
    case Advice::ChangeSomething:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Change one thing before another attempt: the head, the blade, pressure on "
                      "the larynx or the hands."));
    case Advice::SpareTheTeeth:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Do not turn the handle on the teeth: lift it away from you, towards where "
                      "the far wall meets the ceiling."));
    case Advice::AdvanceTube:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Advance the tube to the depth of the rule: a shallow cuff lies between the "
                      "cords and slips out."));
    case Advice::WithdrawTube:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Withdraw the tube to the depth of the rule: when the neck bends the tip "
                      "goes deeper, into one lung."));
    case Advice::InflateCuff:
        return adviceWords(
            QT_TRANSLATE_NOOP("Advice", "Inflate the cuff before the first breath, and say so."));
    case Advice::SpareTheTongue:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Use less force on the tongue: with the tip of the blade in its place a "
                      "smaller lift gives the same view."));
    case Advice::ExtendHead:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Extend the head before the blade goes in, unless the neck may be hurt."));
    case Advice::HoldBladeUpright:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Keep handle and blade in one upright plane along the middle of the "
                      "patient."));
    case Advice::BendLess:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Raise the table until you see the mouth with a straight back: your head "
                      "went up and down a lot."));
    case Advice::BeQuicker:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Have tube, cuff and bag within reach before you begin: the first breath "
                      "came late."));
    case Advice::TryHarderPatient:
        return adviceWords(
            QT_TRANSLATE_NOOP("Advice", "Try the next one with a more difficult airway."));
    case Advice::TryOtherManikin:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Change to another manikin or patient soon: success on one does not carry "
                      "over to the next by itself."));
    case Advice::Repeat:
        return adviceWords(QT_TRANSLATE_NOOP(
            "Advice", "Do it again now: a success teaches more than several failures."));
    }
    return {};
}

} // namespace carina
