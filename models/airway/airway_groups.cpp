#include "models/airway/airway_groups.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

constexpr std::array kMouth{AirwayEventKind::TongueOedema, AirwayEventKind::AngioOedema,
                            AirwayEventKind::ProminentIncisors, AirwayEventKind::FragileTeeth,
                            AirwayEventKind::Trismus};
/// With the epiglottis, which is seen before the larynx is.
constexpr std::array kThroat{AirwayEventKind::PharyngealSwelling, AirwayEventKind::Epiglottitis,
                             AirwayEventKind::FloppyEpiglottis, AirwayEventKind::Burn,
                             AirwayEventKind::Swallowing};
constexpr std::array kLarynx{AirwayEventKind::LaryngealOedema, AirwayEventKind::Laryngospasm,
                             AirwayEventKind::AnteriorLarynx, AirwayEventKind::LaryngealWeb,
                             AirwayEventKind::ForeignBody};
constexpr std::array kNeck{AirwayEventKind::TrachealStenosis, AirwayEventKind::TrachealDeviation,
                           AirwayEventKind::Goitre, AirwayEventKind::NeckObesity,
                           AirwayEventKind::StiffNeck};
constexpr std::array kFluids{AirwayEventKind::Secretions, AirwayEventKind::Blood,
                             AirwayEventKind::Vomit};
constexpr std::array kHelper{AirwayEventKind::ExternalPressure};
static_assert(kMouth.size() + kThroat.size() + kLarynx.size() + kNeck.size() + kFluids.size()
                  + kHelper.size()
              == kAirwayEventKinds);

/// With keys that nothing else of the console's window has.
constexpr std::array kAirwayGroups{
    AirwayGroup{"mouth", QT_TRANSLATE_NOOP("Airway", "Mo&uth"), kMouth},
    AirwayGroup{"throat", QT_TRANSLATE_NOOP("Airway", "&Throat"), kThroat},
    AirwayGroup{"larynx", QT_TRANSLATE_NOOP("Airway", "&Larynx"), kLarynx},
    AirwayGroup{"neck", QT_TRANSLATE_NOOP("Airway", "&Neck"), kNeck},
    AirwayGroup{"fluids", QT_TRANSLATE_NOOP("Airway", "Flu&ids"), kFluids},
    AirwayGroup{"helper", QT_TRANSLATE_NOOP("Airway", "Helpe&r"), kHelper}};

} // namespace

std::span<const AirwayGroup> airwayGroups() { return kAirwayGroups; }

const AirwayGroup* airwayGroupNamed(std::string_view name)
{
    const auto* found = std::ranges::find(kAirwayGroups, name, &AirwayGroup::name);
    return found == kAirwayGroups.end() ? nullptr : found;
}

QString groupText(const AirwayGroup& group)
{
    return QCoreApplication::translate("Airway", group.text);
}

} // namespace carina
