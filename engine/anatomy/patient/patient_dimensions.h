#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"

#include <array>
#include <cstdint>
#include <optional>

namespace carina
{

/// The patients that Carina offers without parameters.
enum class BuiltinPatient : std::uint8_t { Adult, TwelveYears };

enum class Sex : std::uint8_t { Female, Male };
enum class Habitus : std::uint8_t { Slim, Normal, Obese };

/// The ranges of the formulas. Heights are those from kSchoolAge_years on; see heightRange.
inline constexpr double kYoungest_years = 0.0;
inline constexpr double kOldest_years = 90.0;
inline constexpr Length kLeastHeight = metres(1.0);
inline constexpr Length kGreatestHeight = metres(2.1);

/// From here on the formulas are those of older children and grown people. Younger ones have
/// formulas of their own, which meet these at this age.
inline constexpr double kSchoolAge_years = 6.0;

/// The parameters from which a patient is made.
struct PatientParameters {
    double ageInYears = 30.0; ///< kYoungest_years (newborn) to kOldest_years
    Length height;            ///< within heightRange
    Sex sex = Sex::Male;
    Habitus habitus = Habitus::Normal;
    /// Teeth to carina as measured, on a manikin for instance; without it by the formulas.
    std::optional<Length> teethToCarina{};

    friend bool operator==(const PatientParameters&, const PatientParameters&) = default;
};

/// Adult: a man of 30 years and 175 cm. TwelveYears: a boy of 12 years, as
/// the manikin of 2004 (Hamza-Lup, Rolland and Hughes 2004),  and 150 cm.
[[nodiscard]] PatientParameters parametersOf(BuiltinPatient patient);

/// Mucosa and cartilage of the reference man's trachea; of others in proportion to its length.
inline constexpr Length kMansTracheaWall = millimetres(1.8);

/// One main bronchus: from the carina to its first lobar branch.
struct MainBronchusDimensions {
    Length length;     ///< along its axis, from the level of the carina
    Angle fromTrachea; ///< between its axis and the extended axis of the trachea
    Length diameter;
};

/// Shares of the five lobes in the total lung volume; their sum is 1.
struct LobeShares {
    double rightUpper = 0.0;
    double rightMiddle = 0.0;
    double rightLower = 0.0;
    double leftUpper = 0.0;
    double leftLower = 0.0;
};

/// Outer diameters of the trachea's upper end, where it is as narrow as the ring of the cricoid: in
/// children as wide as the rest of it, in grown people narrower, for the opening of their cricoid
/// is smaller than their trachea's.
struct UpperTrachea {
    Length sagittal; ///< front to back
    Length coronal;  ///< side to side
};

/// The dimensions of a patient.
struct PatientDimensions {
    Length height;
    double weightInKilograms = 0.0;
    double ageInYears = 0.0;
    Sex sex = Sex::Male;
    Length cordsToCarina;
    /// Width and depth of the larynx, of those that go with its height below the cords: less in
    /// grown women.
    double larynxGirth = 1.0;
    Length tracheaLength;   ///< lower border of the cricoid to the carina
    Length tracheaSagittal; ///< front to back, mean of rings and gaps
    Length tracheaCoronal;  ///< side to side
    UpperTrachea upperTrachea;
    int tracheaRings = 0;
    MainBronchusDimensions rightBronchus;
    MainBronchusDimensions leftBronchus;
    Length teethToCarina;              ///< along the path of a tube
    Volume functionalResidualCapacity; ///< lungVolumesOf this build
    double rightLungShare = 0.0;       ///< share of the functional residual capacity
    LobeShares lobes;
    double fatness = 0.0;     ///< 1 in Habitus::Obese; of the fat in tongue, throat and neck
    Length fatLayer;          ///< thickness between skin and ribs
    Length tubeInnerDiameter; ///< of a fitting tracheal tube
};

/// Body mass index of Habitus::Normal, kg/m^2: 17.8 at twelve years (40 kg at 150 cm) and 25.1 in
/// adults (the standard patient of Pulse, 77 kg at 175 cm); below kSchoolAge_years about the
/// medians of WHO's growth standards, from 13.3 in the newborn over 17.1 at six months.
[[nodiscard]] double usualBodyMassIndex(double ageInYears);

struct LengthRange {
    Length least;
    Length most;
};

/// The heights that are taken at an age: 45 to 60 cm in the newborn, 65 to 90 cm at one year, and
/// from kSchoolAge_years on kLeastHeight to kGreatestHeight; in between on straight lines, up to
/// 1.4 m, the whole centimetres within them. Lengths of healthy children lie well within these
/// (WHO growth standards).
[[nodiscard]] LengthRange heightRange(double ageInYears);

/// Inner diameter of a fitting cuffed tube: 3.0 mm below eight months, 3.5 below two years, 4.0
/// below four and 4.5 below six (Weiss et al., BJA 2009;103:867), from there on age / 4 + 3.5 mm;
/// 7.0 in women and 8.0 in men. In steps of half a millimetre.
[[nodiscard]] Length usualTube(double ageInYears, Sex sex);

/// The range in which teethToCarina can be set for a patient of this age, height and sex: 15 %
/// below and above the formulas' figure, about one standard deviation of the length from cords to
/// carina (1.6 of 12.7 cm, BJA 2006).
/// @returns OutOfRange, see dimensionsFor.
[[nodiscard]] Result<LengthRange> teethToCarinaRange(PatientParameters parameters);

/// The dimensions of a patient by published formulas; patient_dimensions.cpp gives each source.
/// Where teethToCarina is set, the lengths of the airway (teeth to cords, cords to carina, trachea,
/// main bronchi) are scaled alike to give it.
/// @returns OutOfRange for an age or height outside the range of the formulas, and for a
///          teethToCarina outside teethToCarinaRange.
[[nodiscard]] Result<PatientDimensions> dimensionsFor(const PatientParameters& parameters);

/// The dimensions of a built-in patient.
[[nodiscard]] PatientDimensions dimensionsOf(BuiltinPatient patient);

} // namespace carina
