#pragma once

#include "apps/lab/command/words.h"
#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/patient/patient_dimensions.h"
#include "engine/lungs/mechanics/body_position.h"
#include "engine/lungs/mechanics/lung_condition.h"
#include "engine/lungs/mechanics/respiratory_system.h"
#include "engine/lungs/mechanics/ventilation.h"

namespace carina::lab
{

inline constexpr Option kPatient{
    "patient", "WHO",
    "adult, child (a boy of 12 years), or age (newborn to 90 years), height (100 to 210 cm; below "
    "six years less) and man, woman, boy or girl, with commas between them: \"45 years, 182 cm, "
    "man\", \"1 year, 75 cm, girl\", \"3 months, 60 cm, boy\", \"newborn, 50 cm, girl\"; with slim "
    "or obese where that is so: \"adult, slim\"; with the length from teeth to carina: \"adult, "
    "airway 250 mm\""};
inline constexpr Option kAnatomy{
    "anatomy", "DIR",
    "folder of an anatomy set to draw instead; --patient then says whose breathing it gets (an "
    "adult's)"};
inline constexpr Option kCondition{
    "condition", "NAME",
    "normal (where none is given), ards, copd, asthma, simple_pneumothorax, tension_pneumothorax, "
    "atelectasis, mainstem_intubation, obstruction or stiff_chest"};
inline constexpr Option kSeverity{"severity", "0..1", "of the condition; 0.6 unless given"};
inline constexpr Option kSide{"side", "SIDE",
                              "of the condition: both (unless given), right or left"};
inline constexpr Option kVentilator{
    "ventilator", "MODE", "none (the patient breathes; unless given), volume or pressure control"};
inline constexpr Option kPosition{"position", "NAME",
                                  "position of the patient: supine (unless given), sitting, prone, "
                                  "right_lateral or left_lateral"};

/// Whom kPatient means (see patientFromWords); `otherwise` where it is not given.
/// @returns OutOfRange for a patient there is not.
[[nodiscard]] Result<PatientParameters> patientOption(const Words& words, BuiltinPatient otherwise);

/// The condition that kCondition, kSeverity and kSide ask for.
/// @returns OutOfRange for words and numbers that say none, and for a severity or a side of health.
[[nodiscard]] Result<LungCondition> conditionOption(const Words& words);

/// What makes the breaths by kVentilator.
/// @returns OutOfRange for a ventilator there is not.
[[nodiscard]] Result<VentilationMode> ventilatorOption(const Words& words);

/// Position of the patient by kPosition.
/// @returns OutOfRange for a word that says none.
[[nodiscard]] Result<BodyPosition> positionOption(const Words& words);

/// What size of a patient breathes in subjectOption, without making it.
/// @returns OutOfRange for a patient there is not.
[[nodiscard]] Result<PatientBuild> buildOption(const Words& words);

/// Who is drawn, and what size of a patient breathes.
struct Subject {
    Anatomy anatomy;
    PatientBuild build;
};

/// The set of kAnatomy or the made patient of kPatient; the child without either. A set breathes as
/// the patient asked for with it, or as an adult.
/// @returns OutOfRange for a patient there is not; what reading or making it fails with.
[[nodiscard]] Result<Subject> subjectOption(const Words& words);

/// The set of kAnatomy or the made patient of kPatient with a mouth that is shut and a tongue at
/// rest; the adult without either.
/// @returns likewise
[[nodiscard]] Result<Anatomy> restingOption(const Words& words);

} // namespace carina::lab
