#include "models/physiology/drug_words.h"

#include <QCoreApplication>

namespace carina
{
namespace
{

QString physiologyWords(const char* text)
{
    return QCoreApplication::translate("Physiology", text);
}

} // namespace

QString drugText(DrugKind kind)
{
    switch (kind) {
    case DrugKind::Propofol:
        return physiologyWords(QT_TRANSLATE_NOOP("Physiology", "Propofol"));
    case DrugKind::Ketamine:
        return physiologyWords(QT_TRANSLATE_NOOP("Physiology", "Ketamine"));
    case DrugKind::Fentanyl:
        return physiologyWords(QT_TRANSLATE_NOOP("Physiology", "Fentanyl"));
    case DrugKind::Rocuronium:
        return physiologyWords(QT_TRANSLATE_NOOP("Physiology", "Rocuronium"));
    case DrugKind::Suxamethonium:
        return physiologyWords(QT_TRANSLATE_NOOP("Physiology", "Suxamethonium"));
    case DrugKind::Sugammadex:
        return physiologyWords(QT_TRANSLATE_NOOP("Physiology", "Sugammadex"));
    case DrugKind::Ephedrine:
        return physiologyWords(QT_TRANSLATE_NOOP("Physiology", "Ephedrine"));
    }
    return {};
}

QString doseText(const DrugDose& dose)
{
    constexpr int kDigits = 4;
    return QCoreApplication::translate("Physiology", "%1 %2%3", "drug; number; unit with a blank")
        .arg(drugText(dose.kind))
        .arg(unitsPerMilligram(dose.kind) * dose.milligrams, 0, 'g', kDigits)
        .arg(drugUnit(dose.kind));
}

QString drugUnit(DrugKind kind)
{
    return kind == DrugKind::Fentanyl
               ? physiologyWords(QT_TRANSLATE_NOOP("Physiology", "\u00a0\u00b5g"))
               : physiologyWords(QT_TRANSLATE_NOOP("Physiology", "\u00a0mg"));
}

double unitsPerMilligram(DrugKind kind) { return kind == DrugKind::Fentanyl ? 1000.0 : 1.0; }

double usualDose_mgPerKg(DrugKind kind)
{
    switch (kind) {
    case DrugKind::Propofol:
    case DrugKind::Ketamine:
        return 2.0;
    case DrugKind::Fentanyl:
        return 0.002;
    case DrugKind::Rocuronium:
        return 0.6;
    case DrugKind::Suxamethonium:
        return 1.0;
    case DrugKind::Sugammadex:
        return 4.0;
    case DrugKind::Ephedrine:
        return 0.1;
    }
    return 0.0;
}

QString gasText(const GasSupply& gas)
{
    const QString mask = gas.maskHeld
                             ? physiologyWords(QT_TRANSLATE_NOOP("Physiology", "mask held"))
                             : physiologyWords(QT_TRANSLATE_NOOP("Physiology", "no mask"));
    const QString probe = gas.probeOn
                              ? physiologyWords(QT_TRANSLATE_NOOP("Physiology", "probe on"))
                              : physiologyWords(QT_TRANSLATE_NOOP("Physiology", "probe off"));
    return QCoreApplication::translate("Physiology", "oxygen %1\u00a0%, %2, %3")
        .arg(100.0 * gas.inspiredOxygen, 0, 'f', 0)
        .arg(mask, probe);
}

QString seatText(TubeSeat seat)
{
    switch (seat) {
    case TubeSeat::None:
        return physiologyWords(QT_TRANSLATE_NOOP("Physiology", "above the vocal cords"));
    case TubeSeat::Trachea:
        return physiologyWords(QT_TRANSLATE_NOOP("Physiology", "in the trachea"));
    case TubeSeat::RightMain:
        return physiologyWords(QT_TRANSLATE_NOOP("Physiology", "in the right main bronchus"));
    case TubeSeat::LeftMain:
        return physiologyWords(QT_TRANSLATE_NOOP("Physiology", "in the left main bronchus"));
    case TubeSeat::Oesophagus:
        return physiologyWords(QT_TRANSLATE_NOOP("Physiology", "in the oesophagus"));
    }
    return {};
}

QString setTubeText(const SetTube& tube)
{
    if (!tube.isSet())
        return physiologyWords(QT_TRANSLATE_NOOP("Physiology", "as tracked"));
    return QCoreApplication::translate("Physiology", "%1, %2\u00a0mm", "place of a tube; its size")
        .arg(seatText(tube.seat))
        .arg(inMillimetres(tube.innerDiameter), 0, 'f', 1);
}

} // namespace carina
