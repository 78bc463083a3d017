#pragma once

#include "engine/session/facts/facts.h"

#include <tuple>

namespace carina
{

/// The members of each fact, and of the structures within it, in the order in which they are
/// encoded.
template <class Whole> inline constexpr std::tuple<> kFields;
template <>
inline constexpr std::tuple kFields<fact::SessionCreated>{&fact::SessionCreated::name,
                                                          &fact::SessionCreated::sessionId};
template <> inline constexpr std::tuple kFields<fact::PhaseChanged>{&fact::PhaseChanged::phase};
template <> inline constexpr std::tuple kFields<fact::StationAdded>{&fact::StationAdded::name};
template <>
inline constexpr std::tuple kFields<fact::ParticipantJoined>{&fact::ParticipantJoined::participant,
                                                             &fact::ParticipantJoined::role,
                                                             &fact::ParticipantJoined::name};
template <>
inline constexpr std::tuple kFields<fact::ParticipantLeft>{&fact::ParticipantLeft::participant};
template <>
inline constexpr std::tuple kFields<fact::ObjectShared>{
    &fact::ObjectShared::object, &fact::ObjectShared::owner, &fact::ObjectShared::kind,
    &fact::ObjectShared::name};
template <>
inline constexpr std::tuple kFields<fact::AnatomyChosen>{&fact::AnatomyChosen::contentHash,
                                                         &fact::AnatomyChosen::name};
template <>
inline constexpr std::tuple kFields<fact::BreathingRateSet>{&fact::BreathingRateSet::rate};
template <>
inline constexpr std::tuple kFields<fact::TidalVolumeSet>{&fact::TidalVolumeSet::tidalVolume};
template <>
inline constexpr std::tuple kFields<fact::InspiratoryFractionSet>{
    &fact::InspiratoryFractionSet::fraction};

template <>
inline constexpr std::tuple kFields<fact::ObjectHandedOver>{&fact::ObjectHandedOver::object,
                                                            &fact::ObjectHandedOver::owner,
                                                            &fact::ObjectHandedOver::epoch};

template <>
inline constexpr std::tuple kFields<fact::ObjectWanted>{&fact::ObjectWanted::object,
                                                        &fact::ObjectWanted::wanted};

template <>
inline constexpr std::tuple kFields<fact::PatientBuildSet>{&fact::PatientBuildSet::build};
template <>
inline constexpr std::tuple kFields<PatientBuild>{&PatientBuild::height,
                                                  &PatientBuild::weightInKilograms,
                                                  &PatientBuild::ageInYears, &PatientBuild::sex};

template <>
inline constexpr std::tuple kFields<fact::LungConditionsSet>{&fact::LungConditionsSet::conditions};
template <>
inline constexpr std::tuple kFields<LungCondition>{&LungCondition::kind, &LungCondition::severity,
                                                   &LungCondition::side};

template <>
inline constexpr std::tuple kFields<fact::VentilatorSet>{&fact::VentilatorSet::settings};
template <>
inline constexpr std::tuple kFields<VentilatorSettings>{&VentilatorSettings::mode,
                                                        &VentilatorSettings::peep,
                                                        &VentilatorSettings::drivingPressure,
                                                        &VentilatorSettings::pressureLimit,
                                                        &VentilatorSettings::pauseShare,
                                                        &VentilatorSettings::trigger,
                                                        &VentilatorSettings::ownRate,
                                                        &VentilatorSettings::ownEffort};

template <>
inline constexpr std::tuple kFields<fact::ParticipantMuted>{&fact::ParticipantMuted::participant,
                                                            &fact::ParticipantMuted::muted};
template <>
inline constexpr std::tuple kFields<fact::ParticipantRemoved>{
    &fact::ParticipantRemoved::participant, &fact::ParticipantRemoved::banned,
    &fact::ParticipantRemoved::reason};
template <> inline constexpr std::tuple kFields<fact::BanLifted>{&fact::BanLifted::participant};
template <> inline constexpr std::tuple kFields<fact::SessionLocked>{&fact::SessionLocked::locked};
template <>
inline constexpr std::tuple kFields<fact::RoleCodeChanged>{&fact::RoleCodeChanged::role};
template <>
inline constexpr std::tuple kFields<fact::TokenReplaced>{&fact::TokenReplaced::participant};
template <>
inline constexpr std::tuple kFields<fact::StrategyChosen>{&fact::StrategyChosen::choice};
template <> inline constexpr std::tuple kFields<fact::StationRenamed>{&fact::StationRenamed::name};
template <>
inline constexpr std::tuple kFields<fact::ParticipantMoved>{&fact::ParticipantMoved::participant};
template <>
inline constexpr std::tuple kFields<StrategyChoice>{&StrategyChoice::kind, &StrategyChoice::asa,
                                                    &StrategyChoice::longestLag};
template <>
inline constexpr std::tuple kFields<AsaParameters>{&AsaParameters::delays, &AsaParameters::start,
                                                   &AsaParameters::lowest, &AsaParameters::highest};

template <>
inline constexpr std::tuple kFields<fact::RegistrationStated>{&fact::RegistrationStated::standing};
template <>
inline constexpr std::tuple kFields<RegistrationStanding>{
    &RegistrationStanding::state, &RegistrationStanding::reason, &RegistrationStanding::error};
template <>
inline constexpr std::tuple kFields<fact::ParticipantFellSilent>{
    &fact::ParticipantFellSilent::participant};
template <>
inline constexpr std::tuple kFields<fact::WorkTaken>{&fact::WorkTaken::participant,
                                                     &fact::WorkTaken::before};
template <>
inline constexpr std::tuple kFields<fact::PlaceChosen>{&fact::PlaceChosen::participant,
                                                       &fact::PlaceChosen::turn};

template <>
inline constexpr std::tuple kFields<fact::LessonShown>{&fact::LessonShown::to,
                                                       &fact::LessonShown::lesson};
template <>
inline constexpr std::tuple kFields<Lesson>{&Lesson::section, &Lesson::showsView, &Lesson::looks};
template <>
inline constexpr std::tuple kFields<LessonSection>{
    &LessonSection::isCut, &LessonSection::cut, &LessonSection::normal_A, &LessonSection::distance};
template <>
inline constexpr std::tuple kFields<LessonLook>{&LessonLook::first,   &LessonLook::last,
                                                &LessonLook::style,   &LessonLook::isHighlighted,
                                                &LessonLook::isNamed, &LessonLook::isPlain};

template <>
inline constexpr std::tuple kFields<fact::AirwayEventsSet>{&fact::AirwayEventsSet::events,
                                                           &fact::AirwayEventsSet::over};
template <>
inline constexpr std::tuple kFields<AirwayEvent>{&AirwayEvent::kind, &AirwayEvent::severity};
template <>
inline constexpr std::tuple kFields<fact::HeadPositionSet>{&fact::HeadPositionSet::position,
                                                           &fact::HeadPositionSet::over};
template <>
inline constexpr std::tuple kFields<HeadPosition>{&HeadPosition::flexion, &HeadPosition::extension};

template <> inline constexpr std::tuple kFields<fact::TubePlaced>{&fact::TubePlaced::tube};
template <> inline constexpr std::tuple kFields<SetTube>{&SetTube::seat, &SetTube::innerDiameter};
template <>
inline constexpr std::tuple kFields<fact::BodyPositionSet>{&fact::BodyPositionSet::position};
template <>
inline constexpr std::tuple kFields<fact::BreathingStopped>{&fact::BreathingStopped::stopped,
                                                            &fact::BreathingStopped::over};
template <> inline constexpr std::tuple kFields<fact::BagSqueezed>{&fact::BagSqueezed::bag};
template <> inline constexpr std::tuple kFields<HandBag>{&HandBag::rate, &HandBag::tidalVolume};
template <>
inline constexpr std::tuple kFields<fact::ManikinBreathed>{&fact::ManikinBreathed::began};

template <> inline constexpr std::tuple kFields<fact::GasSupplySet>{&fact::GasSupplySet::gas};
template <>
inline constexpr std::tuple kFields<GasSupply>{&GasSupply::inspiredOxygen, &GasSupply::maskHeld,
                                               &GasSupply::probeOn};
template <> inline constexpr std::tuple kFields<fact::DrugGiven>{&fact::DrugGiven::dose};
template <> inline constexpr std::tuple kFields<DrugDose>{&DrugDose::kind, &DrugDose::milligrams};
template <> inline constexpr std::tuple kFields<fact::CuffSet>{&fact::CuffSet::inflated};
template <> inline constexpr std::tuple kFields<fact::TubeObstructed>{&fact::TubeObstructed::share};
template <>
inline constexpr std::tuple kFields<fact::IntubationNoted>{&fact::IntubationNoted::event,
                                                           &fact::IntubationNoted::innerDiameter};
template <>
inline constexpr std::tuple kFields<IntubationEvent>{
    &IntubationEvent::step,         &IntubationEvent::at,
    &IntubationEvent::seat,         &IntubationEvent::confidence,
    &IntubationEvent::depthAtTeeth, &IntubationEvent::tipAboveCarina,
    &IntubationEvent::besides,      &IntubationEvent::glotticOpening};

template <>
inline constexpr std::tuple kFields<fact::CapnographCheckpoint>{&fact::CapnographCheckpoint::at,
                                                                &fact::CapnographCheckpoint::state};
template <>
inline constexpr std::tuple kFields<CapnographState>{
    &CapnographState::connector_mmHg, &CapnographState::line,
    &CapnographState::next,           &CapnographState::sensor_mmHg,
    &CapnographState::inBreath,       &CapnographState::hasBreath,
    &CapnographState::highest_mmHg,   &CapnographState::lowest_mmHg,
    &CapnographState::endTidal_mmHg,  &CapnographState::rate_perS,
    &CapnographState::sinceBreath_s,  &CapnographState::stomach_mmHg,
    &CapnographState::stomachPhase};

template <>
inline constexpr std::tuple kFields<fact::BodyCheckpoint>{&fact::BodyCheckpoint::at,
                                                          &fact::BodyCheckpoint::state};
/// Without the capnograph, of which CapnographCheckpoint is.
template <>
inline constexpr std::tuple kFields<BodyState>{
    &BodyState::steps,       &BodyState::gas,   &BodyState::blood, &BodyState::oximeter,
    &BodyState::circulation, &BodyState::drugs, &BodyState::spasm};
template <>
inline constexpr std::tuple kFields<AirwayGas>{&AirwayGas::lungs,      &AirwayGas::airway,
                                               &AirwayGas::inhaled_ml, &AirwayGas::exhaled_ml,
                                               &AirwayGas::openShare,  &AirwayGas::filled};
template <>
inline constexpr std::tuple kFields<LungGas>{&LungGas::oxygen_ml, &LungGas::carbonDioxide_ml,
                                             &LungGas::nitrogen_ml};
template <>
inline constexpr std::tuple kFields<GasShares>{&GasShares::oxygen, &GasShares::carbonDioxide};
template <>
inline constexpr std::tuple kFields<BloodGas>{&BloodGas::arterialOxygen_mlPerL,
                                              &BloodGas::venousOxygen_mlPerL,
                                              &BloodGas::restingOxygen_mlPerL,
                                              &BloodGas::arterialCarbonDioxide_mmHg,
                                              &BloodGas::tissueCarbonDioxide_mmHg,
                                              &BloodGas::lungCarbonDioxide_mmHg,
                                              &BloodGas::constriction};
template <>
inline constexpr std::tuple kFields<OximeterState>{&OximeterState::way, &OximeterState::steps,
                                                   &OximeterState::shown};
template <>
inline constexpr std::tuple kFields<CirculationState>{
    &CirculationState::heartRate_perS, &CirculationState::mean_mmHg,  &CirculationState::pulse_mmHg,
    &CirculationState::alarm,          &CirculationState::accustomed, &CirculationState::harm,
    &CirculationState::beat,           &CirculationState::arrested};
template <>
inline constexpr std::tuple kFields<DrugAmounts>{&DrugAmounts::vein_mg, &DrugAmounts::central_mg,
                                                 &DrugAmounts::fast_mg, &DrugAmounts::slow_mg,
                                                 &DrugAmounts::effect_mgPerL};

template <>
inline constexpr std::tuple kFields<fact::RespirationCheckpoint>{
    &fact::RespirationCheckpoint::at, &fact::RespirationCheckpoint::state};
template <>
inline constexpr std::tuple kFields<RespiratoryState>{
    &RespiratoryState::steps,  &RespiratoryState::system,     &RespiratoryState::content,
    &RespiratoryState::clock,  &RespiratoryState::ventilator, &RespiratoryState::breath,
    &RespiratoryState::effort, &RespiratoryState::muscle,     &RespiratoryState::opening,
    &RespiratoryState::tally,  &RespiratoryState::last,       &RespiratoryState::drive};
template <>
inline constexpr std::tuple kFields<DriveState>{&DriveState::carbonDioxide, &DriveState::tiredness};
template <>
inline constexpr std::tuple kFields<RespiratorySystem>{&RespiratorySystem::lungs,
                                                       &RespiratorySystem::upperLaminar,
                                                       &RespiratorySystem::upperTurbulent,
                                                       &RespiratorySystem::mediastinum,
                                                       &RespiratorySystem::mediastinumMost,
                                                       &RespiratorySystem::mediastinalWeight,
                                                       &RespiratorySystem::anatomicalDeadSpace,
                                                       &RespiratorySystem::effort,
                                                       &RespiratorySystem::strength,
                                                       &RespiratorySystem::inspiratoryRatio,
                                                       &RespiratorySystem::sag};
template <>
inline constexpr std::tuple kFields<LungMechanics>{
    &LungMechanics::curve,       &LungMechanics::limbSpread,
    &LungMechanics::limbVolume,  &LungMechanics::bronchi,
    &LungMechanics::compression, &LungMechanics::closing,
    &LungMechanics::wall,        &LungMechanics::wallVolume,
    &LungMechanics::wallRecoil,  &LungMechanics::drive,
    &LungMechanics::pleuralGas,  &LungMechanics::valve,
    &LungMechanics::relief,      &LungMechanics::uptake,
    &LungMechanics::uptakeEnd,   &LungMechanics::alveolarDeadSpace};
template <>
inline constexpr std::tuple kFields<PressureVolumeCurve>{
    &PressureVolumeCurve::floor, &PressureVolumeCurve::span, &PressureVolumeCurve::centre,
    &PressureVolumeCurve::width};
template <>
inline constexpr std::tuple kFields<LungContent>{&LungContent::gas, &LungContent::limb,
                                                 &LungContent::trapped};
template <>
inline constexpr std::tuple kFields<BreathClock::State>{
    &BreathClock::State::breaths, &BreathClock::State::rate,         &BreathClock::State::measured,
    &BreathClock::State::pull,    &BreathClock::State::sinceTrigger, &BreathClock::State::triggered,
    &BreathClock::State::bridged};
template <> inline constexpr std::tuple kFields<VentilatorState>{&VentilatorState::sinceBreath};
template <>
inline constexpr std::tuple kFields<BreathingPattern>{&BreathingPattern::rate,
                                                      &BreathingPattern::tidalVolume,
                                                      &BreathingPattern::inspiratoryFraction};
template <>
inline constexpr std::tuple kFields<AirwayOpening>{&AirwayOpening::drivesFlow,
                                                   &AirwayOpening::pressure, &AirwayOpening::flow};
template <>
inline constexpr std::tuple kFields<BreathTally>{&BreathTally::steps, &BreathTally::inspired,
                                                 &BreathTally::least, &BreathTally::most,
                                                 &BreathTally::peak,  &BreathTally::plateau};
template <>
inline constexpr std::tuple kFields<BreathFigures>{
    &BreathFigures::tidalVolume, &BreathFigures::tidalVolumeOfLung,
    &BreathFigures::rate,        &BreathFigures::peak,
    &BreathFigures::plateau,     &BreathFigures::endExpiratory,
    &BreathFigures::autoPeep,    &BreathFigures::alveolarVentilation};

/// The last enumerator; decoders refuse greater values.
template <class Enum> inline constexpr Enum kLastEnumerator{};
template <> inline constexpr SessionPhase kLastEnumerator<SessionPhase> = SessionPhase::Ended;
template <> inline constexpr Role kLastEnumerator<Role> = Role::Observer;
template <> inline constexpr StrategyKind kLastEnumerator<StrategyKind> = StrategyKind::None;
template <>
inline constexpr RegistrationState kLastEnumerator<RegistrationState> =
    RegistrationState::NoTracker;
template <> inline constexpr StaleReason kLastEnumerator<StaleReason> = StaleReason::Drift;
template <> inline constexpr ObjectKind kLastEnumerator<ObjectKind> = ObjectKind::Pointer;
template <> inline constexpr LessonCut kLastEnumerator<LessonCut> = LessonCut::AllButAirway;
template <> inline constexpr LessonStyle kLastEnumerator<LessonStyle> = LessonStyle::Hidden;
template <> inline constexpr Sex kLastEnumerator<Sex> = Sex::Male;
template <>
inline constexpr ConditionKind kLastEnumerator<ConditionKind> = ConditionKind::StiffChest;
template <> inline constexpr ConditionSide kLastEnumerator<ConditionSide> = ConditionSide::Left;
template <>
inline constexpr AirwayEventKind kLastEnumerator<AirwayEventKind> = AirwayEventKind::Swallowing;
template <> inline constexpr BodyPosition kLastEnumerator<BodyPosition> = BodyPosition::LeftLateral;
template <> inline constexpr DrugKind kLastEnumerator<DrugKind> = DrugKind::Ephedrine;
template <> inline constexpr TubeSeat kLastEnumerator<TubeSeat> = TubeSeat::Oesophagus;
template <> inline constexpr IntubationStep kLastEnumerator<IntubationStep> = kLastIntubationStep;
template <>
inline constexpr VentilationMode kLastEnumerator<VentilationMode> =
    VentilationMode::PressureControl;

} // namespace carina
