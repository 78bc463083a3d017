#include "models/airway/airway_presets.h"

#include "models/airway/airway_words.h"
#include "models/airway/head_positions.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace carina
{
namespace
{

using enum AirwayEventKind;

constexpr std::size_t kMostNamed = 2; ///< where there is little room

/// Whole per cents, as the console sets them: who sets one otherwise and back has the preset again.
AirwayEvents middlesOf(const std::vector<SeverityRange>& ranges)
{
    AirwayEvents events;
    for (const SeverityRange& range : ranges)
        events.push_back(
            {range.kind, std::round(100.0 * std::midpoint(range.least, range.most)) / 100.0});
    return events;
}

/// Named for what a Macintosh 3 that is lifted as usual shows of an adult in neutral position.
AirwayPreset graded(int grade, std::string_view name, const char* text,
                    std::vector<SeverityRange> ranges)
{
    return {name, text, middlesOf(ranges), grade, std::move(ranges)};
}

/// The same for who looks past the blade, in the sniffing position as far as the neck goes there:
/// a camera at the blade's end has the epiglottis before it always.
AirwayPreset gradedDirectly(int grade, std::string_view name, const char* text,
                            std::vector<SeverityRange> ranges)
{
    AirwayPreset preset = graded(grade, name, text, std::move(ranges));
    preset.look = {ScopeEye::Direct, kSniffing};
    return preset;
}

constexpr const char* kEpiglottisSource =
    "an epiglottis that cannot be lifted makes grade 3 difficult (Cook, Anaesthesia 2000;55:274)";
constexpr const char* kMotionSource =
    "head and neck that move little went with difficult laryngoscopy (Wilson et al., Br J Anaesth "
    "1988;61:211)";
constexpr const char* kOfOurs = "of ours";
constexpr const char* kNeckSource =
    "a thicker neck went with difficult intubation (Brodsky et al., Anesth Analg 2002;94:732)";

const auto& presets()
{
    static const std::array all{
        AirwayPreset{"clear", QT_TRANSLATE_NOOP("Airway", "Clear"), {}},
        graded(1, "cormack_lehane_1", QT_TRANSLATE_NOOP("Airway", "Cormack-Lehane 1"),
               {{AnteriorLarynx, 0.04, 0.2, kOfOurs}, {NeckObesity, 0.05, 0.25, kNeckSource}}),
        graded(
            2, "cormack_lehane_2", QT_TRANSLATE_NOOP("Airway", "Cormack-Lehane 2"),
            {{FloppyEpiglottis, 0.5, 0.7, kEpiglottisSource}, {AnteriorLarynx, 0.4, 0.6, kOfOurs}}),
        // Fitted until no camera sees the glottis: four events, two nearly as severe as is drawn.
        graded(3, "cormack_lehane_3", QT_TRANSLATE_NOOP("Airway", "Cormack-Lehane 3"),
               {{Epiglottitis, 0.96, 1.0, kEpiglottisSource},
                {FloppyEpiglottis, 0.96, 1.0, kEpiglottisSource},
                {AnteriorLarynx, 0.5, 0.7, kOfOurs},
                {Trismus, 0.7, 0.9, kOfOurs}}),
        gradedDirectly(4, "cormack_lehane_4",
                       QT_TRANSLATE_NOOP("Airway", "Cormack-Lehane 4, direct view"),
                       {{AnteriorLarynx, 0.5, 0.8, kOfOurs}, {StiffNeck, 0.9, 1.0, kMotionSource}}),
        AirwayPreset{"swollen_mouth",
                     QT_TRANSLATE_NOOP("Airway", "Swollen tongue and pharynx"),
                     {{TongueOedema, 0.7}, {PharyngealSwelling, 0.6}}},
        AirwayPreset{"anaphylaxis",
                     QT_TRANSLATE_NOOP("Airway", "Anaphylaxis"),
                     {{TongueOedema, 0.5},
                      {PharyngealSwelling, 0.6},
                      {LaryngealOedema, 0.8},
                      {AngioOedema, 0.7}}},
        AirwayPreset{"swollen_lips",
                     QT_TRANSLATE_NOOP("Airway", "Swollen lips and tongue"),
                     {{TongueOedema, 0.4}, {AngioOedema, 0.9}}},
        // By an ACE inhibitor. Of 108 patients those who were intubated had a massive tongue and
        // floor of the mouth (Ann Otol Rhinol Laryngol 2001;110:834); of 311, tongue, soft palate
        // and aryepiglottic folds went with an intervention, lips alone did not (Kieu et al.,
        // Otolaryngol Head Neck Surg 2015;153:544). The event itself has the folds swell.
        AirwayPreset{"angio_oedema",
                     QT_TRANSLATE_NOOP("Airway", "Angio-oedema, tongue and palate"),
                     {{TongueOedema, 0.8}, {PharyngealSwelling, 0.4}, {AngioOedema, 0.7}}},
        AirwayPreset{"acute_epiglottitis",
                     QT_TRANSLATE_NOOP("Airway", "Acute epiglottitis"),
                     {{Epiglottitis, 0.9}, {LaryngealOedema, 0.4}}},
        AirwayPreset{
            "burn", QT_TRANSLATE_NOOP("Airway", "Burn of the upper airway"), {{Burn, 1.0}}},
        AirwayPreset{"anterior_floppy",
                     QT_TRANSLATE_NOOP("Airway", "Anterior larynx, floppy epiglottis"),
                     {{FloppyEpiglottis, 0.7}, {AnteriorLarynx, 0.8}}},
        AirwayPreset{"spasm",
                     QT_TRANSLATE_NOOP("Airway", "Spasm after extubation"),
                     {{LaryngealOedema, 0.2}, {Laryngospasm, 1.0}}},
        AirwayPreset{"web", QT_TRANSLATE_NOOP("Airway", "Congenital web"), {{LaryngealWeb, 0.7}}},
        AirwayPreset{"anterior_pressed",
                     QT_TRANSLATE_NOOP("Airway", "BURP on an anterior larynx"),
                     {{AnteriorLarynx, 0.8}, {ExternalPressure, 1.0}}},
        AirwayPreset{"obese",
                     QT_TRANSLATE_NOOP("Airway", "Obese"),
                     {{TongueOedema, 0.1}, {NeckObesity, 0.8}}},
        // At the end of labour the airway's class was one grade higher than before in 20 of 61
        // women, and two in 3; volume of the mouth and area of the pharynx were smaller (Kodali et
        // al., Anesthesiology 2008;108:357). Mucosa is engorged along the airway (Clinical
        // Anesthesia Procedures, 9th ed. 2019, table 32.1), fat and fluid are gained (Khan, Anaesth
        // Pain Intensive Care 2014;18:387).
        AirwayPreset{"pregnant",
                     QT_TRANSLATE_NOOP("Airway", "Pregnant, late in labour"),
                     {{TongueOedema, 0.2},
                      {PharyngealSwelling, 0.4},
                      {LaryngealOedema, 0.2},
                      {NeckObesity, 0.3}}},
        AirwayPreset{
            "trauma_collar",
            QT_TRANSLATE_NOOP("Airway", "Trauma with collar"),
            {{TongueOedema, 0.3}, {PharyngealSwelling, 0.3}, {Trismus, 0.7}, {StiffNeck, 0.9}},
            0,
            {},
            {},
            QT_TRANSLATE_NOOP("Airway", "No collar is drawn: the stiff neck stands for one.")},
        AirwayPreset{"goitre",
                     QT_TRANSLATE_NOOP("Airway", "Large goitre"),
                     {{TrachealDeviation, 0.4}, {Goitre, 0.9}}},
        AirwayPreset{"after_tracheostomy",
                     QT_TRANSLATE_NOOP("Airway", "Stenosis after tracheostomy"),
                     {{TrachealStenosis, 0.8}}},
        AirwayPreset{"overjet",
                     QT_TRANSLATE_NOOP("Airway", "Prominent teeth, mouth opens little"),
                     {{ProminentIncisors, 0.9}, {Trismus, 0.5}}}};
    return all;
}

template <class Is> const AirwayPreset* firstThat(const Is& is)
{
    const auto found = std::ranges::find_if(presets(), is);
    return found == presets().end() ? nullptr : &*found;
}

} // namespace

std::span<const AirwayPreset> airwayPresets() { return presets(); }

const AirwayPreset* presetNamed(std::string_view name)
{
    return firstThat([name](const AirwayPreset& preset) { return preset.name == name; });
}

const AirwayPreset* presetOf(const AirwayEvents& events)
{
    return firstThat([&events](const AirwayPreset& preset) { return preset.events == events; });
}

QString presetText(const AirwayPreset& preset)
{
    return QCoreApplication::translate("Airway", preset.text);
}

QString airwayText(const AirwayEvents& events)
{
    const AirwayPreset* preset = events.size() > 1 ? presetOf(events) : nullptr;
    return preset ? presetText(*preset) : eventsText(events);
}

QString shortAirwayText(const AirwayEvents& events)
{
    if (events.size() <= kMostNamed || presetOf(events))
        return airwayText(events);
    const auto worst = std::ranges::max_element(events, {}, &AirwayEvent::severity);
    return QCoreApplication::translate("Airway", "%1 + %2 more", "an event; how many others")
        .arg(eventsText({*worst}))
        .arg(events.size() - 1);
}

QString limitsText(const AirwayPreset& preset)
{
    if (preset.grade == 0)
        return QCoreApplication::translate("Airway", preset.notDrawn);
    const UsualHeadPosition* usual = usualOf(preset.look.head);
    const QString head = usual ? usualText(*usual) : headFiguresText(preset.look.head);
    if (preset.look.eye == ScopeEye::Direct)
        return QCoreApplication::translate(
                   "Airway", "Grade %1 is promised only of an adult with the head in the position "
                             "%2, to the eye that looks past a Macintosh 3 lifted as usual. The "
                             "picture of the laryngoscope is of its camera, which sees more.")
            .arg(preset.grade)
            .arg(head);
    return QCoreApplication::translate(
               "Airway", "Grade %1 is promised only of an adult with the head in the position %2, "
                         "in the camera of a Macintosh 3 lifted as usual.")
        .arg(preset.grade)
        .arg(head);
}

AirwayEvents drawnFrom(const AirwayPreset& preset, std::mt19937& random)
{
    AirwayEvents events = preset.ranges.empty() ? preset.events : AirwayEvents{};
    for (const SeverityRange& range : preset.ranges) {
        const double share = double(random()) / double(std::mt19937::max());
        events.push_back({range.kind, std::lerp(range.least, range.most, share)});
    }
    return events;
}

bool isNamedFor(const AirwayPreset& preset, CormackLehane grade)
{
    return preset.grade > 0 && gradeName(grade)[0] == '0' + preset.grade;
}

} // namespace carina
