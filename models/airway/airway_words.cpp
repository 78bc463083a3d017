#include "models/airway/airway_words.h"

#include <QCoreApplication>
#include <QStringList>

namespace carina
{
namespace
{

QString airwayWords(const char* text) { return QCoreApplication::translate("Airway", text); }

} // namespace

QString eventText(AirwayEventKind kind)
{
    switch (kind) {
    case AirwayEventKind::TongueOedema:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Tongue oedema"));
    case AirwayEventKind::PharyngealSwelling:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Pharyngeal swelling"));
    case AirwayEventKind::Epiglottitis:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Epiglottitis"));
    case AirwayEventKind::LaryngealOedema:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Laryngeal oedema"));
    case AirwayEventKind::Laryngospasm:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Laryngospasm"));
    case AirwayEventKind::FloppyEpiglottis:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Floppy epiglottis"));
    case AirwayEventKind::AnteriorLarynx:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Anterior larynx"));
    case AirwayEventKind::AngioOedema:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Angio-oedema"));
    case AirwayEventKind::LaryngealWeb:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Laryngeal web"));
    case AirwayEventKind::ExternalPressure:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Pressure on the larynx (BURP)"));
    case AirwayEventKind::TrachealStenosis:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Tracheal stenosis"));
    case AirwayEventKind::TrachealDeviation:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Tracheal deviation"));
    case AirwayEventKind::Goitre:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Goitre"));
    case AirwayEventKind::NeckObesity:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Obesity of the neck"));
    case AirwayEventKind::ProminentIncisors:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Prominent incisors"));
    case AirwayEventKind::Trismus:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Trismus"));
    case AirwayEventKind::StiffNeck:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Stiff neck"));
    case AirwayEventKind::Burn:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Burn"));
    case AirwayEventKind::Secretions:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Secretions"));
    case AirwayEventKind::Blood:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Blood"));
    case AirwayEventKind::Vomit:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Vomit"));
    case AirwayEventKind::ForeignBody:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Foreign body"));
    case AirwayEventKind::FragileTeeth:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Loose teeth"));
    case AirwayEventKind::Swallowing:
        return airwayWords(QT_TRANSLATE_NOOP("Airway", "Swallowing"));
    }
    return {};
}

QString eventEffect(AirwayEventKind kind)
{
    switch (kind) {
    case AirwayEventKind::TongueOedema:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway",
            "The tongue swells towards palate and pharynx, and leaves a blade less room"));
    case AirwayEventKind::PharyngealSwelling:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "The side walls of the pharynx come inward, in front of the larynx"));
    case AirwayEventKind::Epiglottitis:
        return airwayWords(
            QT_TRANSLATE_NOOP("Airway", "The epiglottis swells to a ball, and hides the glottis"));
    case AirwayEventKind::LaryngealOedema:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "Arytenoids and aryepiglottic folds swell over the glottis"));
    case AirwayEventKind::Laryngospasm:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "The vocal cords shut: in part they leave a slit, at 100 % nothing"));
    case AirwayEventKind::FloppyEpiglottis:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "The epiglottis falls back over the glottis; a straight blade lifts it"));
    case AirwayEventKind::AnteriorLarynx:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "The larynx lies farther to the front, out of the line of sight"));
    case AirwayEventKind::AngioOedema:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "Lips, the front of the tongue and the entrance of the larynx swell"));
    case AirwayEventKind::LaryngealWeb:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "The vocal cords are joined in front, and leave a tube less room"));
    case AirwayEventKind::ExternalPressure:
        return airwayWords(
            QT_TRANSLATE_NOOP("Airway", "A manoeuvre, no disease: the larynx is pressed back, up "
                                        "and to the right, so that more of the glottis is seen"));
    case AirwayEventKind::TrachealStenosis:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway",
            "The trachea is narrow below the cords, where a tube stops that passed them"));
    case AirwayEventKind::TrachealDeviation:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "The trachea goes to the patient's right between larynx and carina"));
    case AirwayEventKind::Goitre:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "A swelling bulges in front of the trachea, narrows it and pushes it aside"));
    case AirwayEventKind::NeckObesity:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway",
            "The pharynx is narrower, the base of the tongue larger and the neck thicker"));
    case AirwayEventKind::ProminentIncisors:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "The upper incisors stand out and lower, and leave a blade less room"));
    case AirwayEventKind::Trismus:
        return airwayWords(
            QT_TRANSLATE_NOOP("Airway", "The mouth is drawn open less, at 100 % by 10 mm at most; "
                                        "a manikin's own jaw is not held"));
    case AirwayEventKind::StiffNeck:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "Head and neck are drawn to move less from the neutral position, at 100 % "
                      "not at all, as in a rigid collar; a manikin's own neck is not held"));
    case AirwayEventKind::Burn:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "Mouth, throat and larynx are red, sooty and swollen, as from hot smoke"));
    case AirwayEventKind::Secretions:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "Saliva and mucus stand behind the larynx, at 100 % over half of the "
                      "glottis; Suction of all fluids takes them away"));
    case AirwayEventKind::Blood:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway",
            "Blood stands behind the larynx, at 100 % over half of the glottis; Suction of "
            "all fluids takes it away"));
    case AirwayEventKind::Vomit:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway",
            "Vomit stands behind the larynx, at 100 % over half of the glottis; Suction of "
            "all fluids takes it away"));
    case AirwayEventKind::ForeignBody:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "A solid of 15 mm lies beside the larynx, at 100 % over the glottis"));
    case AirwayEventKind::FragileTeeth:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "An upper incisor leans out of the row, at 100 % by 1.5 mm; beneath the "
                      "laryngoscope's picture the teeth are called loose, and a blade near them is "
                      "warned of, at 100 % from 3 mm on"));
    case AirwayEventKind::Swallowing:
        return airwayWords(QT_TRANSLATE_NOOP(
            "Airway", "Every 8 seconds the patient swallows: the vocal cords shut, the larynx "
                      "rises, at 100 % by 15 mm, and the epiglottis falls back over it; not while "
                      "drugs relax the muscles or keep the patient deeply asleep"));
    }
    return {};
}

QString eventsText(const AirwayEvents& events)
{
    QStringList texts;
    for (const AirwayEvent& event : events)
        texts += QCoreApplication::translate("Airway", "%1 %2\u00a0%",
                                             "event of the airway; severity in per cent")
                     .arg(eventText(event.kind))
                     .arg(qRound(100.0 * event.severity));
    return texts.isEmpty() ? airwayWords(QT_TRANSLATE_NOOP("Airway", "Clear"))
                           : texts.join(QStringLiteral(" + "));
}

} // namespace carina
