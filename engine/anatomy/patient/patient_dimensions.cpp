#include "engine/anatomy/patient/patient_dimensions.h"

#include "engine/anatomy/patient/patient_build.h"
#include "engine/core/expects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace carina
{

namespace
{

constexpr Length centimetres(double cm) { return millimetres(10.0 * cm); }

/// 0 at `from` or before, 1 at `to` or beyond, straight between.
double shareBetween(double from, double to, double x)
{
    return std::clamp((x - from) / (to - from), 0.0, 1.0);
}

double mix(double a, double b, double share) { return a + share * (b - a); }
Length mix(Length a, Length b, double share) { return metres(mix(a.si, b.si, share)); }

/// A value at x on straight lines between knots, constant beyond them.
template <std::size_t kCount>
double onLines(const std::array<std::array<double, 2>, kCount>& knots, double x)
{
    for (std::size_t i = 1; i < kCount; ++i)
        if (x < knots[i][0])
            return mix(knots[i - 1][1], knots[i][1], shareBetween(knots[i - 1][0], knots[i][0], x));
    return knots.back()[1];
}

/// 0 up to three years, 1 from school age on: the windpipe goes from an infant's to a child's
/// formulas.
double leftInfancy(double ageInYears) { return shareBetween(3.0, kSchoolAge_years, ageInYears); }

/// The share of the adult size that a trachea has. Boys and girls are alike until fourteen, when
/// girls have stopped growing and boys go on (Griscom and Wohl 1986).
double maturity(const PatientParameters& p)
{
    return p.sex == Sex::Male ? shareBetween(14.0, 18.0, p.ageInYears)
                              : shareBetween(12.0, 14.0, p.ageInYears);
}

/// What a windpipe measures at one height.
struct Windpipe {
    Length cordsToCarina;
    Length tracheaLength;
    Length sagittal;
    Length coronal;
    UpperTrachea upper;
    Length rightBronchus;

    /// Lengths and diameters go with the 1.3th power of height (exponents 1.22 to 1.37, ARRD 1985).
    [[nodiscard]] Windpipe at(Length height, Length reference) const
    {
        const double growth = std::pow(height / reference, 1.3);
        return {growth * cordsToCarina,
                growth * tracheaLength,
                growth * sagittal,
                growth * coronal,
                {growth * upper.sagittal, growth * upper.coronal},
                growth * rightBronchus};
    }
};

constexpr Length kMansHeight = centimetres(175.0);
constexpr Length kWomansHeight = centimetres(162.0);
constexpr Length kChildsHeight = centimetres(150.0);

/// Cords to carina 12.7 (1.6) cm, Caucasian adults (BJA 2006); trachea 10.1 cm (Kumari 2019).
/// Diameters: midway between means of CT of 100 (Lee et al. 1988), air of 18.9 (2.1) mm front to
/// back and 17.7 (1.9) mm side to side in men, and of radiographs of 808 (Breatnach 1984), 20.0
/// (2.3) and 19.0 (2.0); within the wall of kMansTracheaWall. The upper
/// end is what gives the cricoid an opening of 14.11 (2.55) by 17.52 (2.64) mm (31 larynges).
constexpr Windpipe kMan{centimetres(12.7),
                        centimetres(10.1),
                        millimetres(23.05),
                        millimetres(21.95),
                        {millimetres(16.3), millimetres(20.2)},
                        centimetres(2.5)};
/// Cords to carina 12.0 cm (Indian women, Kumari 2019). Trachea between 9.4 cm there and 9.83
/// (0.87) cm in CT of 60 (Kamel 2009), which leaves a larynx that is less high than a man's:
/// women's are 36 mm long and men's 44 (Gray 1918), the lamina of the cricoid is 18.4 and 21.2 mm
/// high. Diameters as in the man: air of 15.5 (1.3) by 15.3 (1.2) and of 16.5 (2.2) by 15.5 (1.8)
/// mm, a cricoid of 12.71 (0.45) by 15.05 (1.02) mm.
constexpr Windpipe kWoman{centimetres(12.0),
                          centimetres(9.7),
                          millimetres(19.5),
                          millimetres(18.9),
                          {millimetres(14.4), millimetres(16.8)},
                          centimetres(2.26)};

/// Of the front and the back wall of a trachea, or of both sides.
Length wallsOf(Length trachea) { return 2.0 * (trachea / kMan.tracheaLength) * kMansTracheaWall; }

/// Lengths from the man's by height; the air, of 12.3 by 12.6 mm, is the mean of the rows for 10-12
/// and 12-14 years (CT, Griscom and Wohl 1986): nearly round.
Windpipe childsAt(Length height)
{
    Windpipe child = kMan.at(kChildsHeight, kMansHeight);
    const Length walls = wallsOf(child.tracheaLength);
    child.sagittal = millimetres(12.3) + walls;
    child.coronal = millimetres(12.6) + walls;
    child.upper = {child.sagittal, child.coronal};
    return child.at(height, kChildsHeight);
}

/// Cords to carina: a line of ours from 5.1 cm at 50 cm to what childsAt gives at 116 cm. It lies
/// between 5.04 cm in 34 infants below three months (bronchoscopy, Ann Otol Rhinol Laryngol
/// 2001;110:268) and 5.3 cm + 0.5 mm a month in 56 children of up to three years (CT, Anesth Analg
/// 2013;117:460). The trachea begins 9.2 mm below the cords at 50 cm (5.04 less 4.12 cm, the same
/// infants), and as far as in childsAt at 116 cm. Its air is 0.0070 h + 0.05 cm from front to back
/// and 0.0065 h + 0.18 cm from side to side (Griscom et al., 34 children up to six years, CT),
/// within the wall that kMansTracheaWall gives to a trachea of this length.
Windpipe infantsAt(Length height)
{
    constexpr Length kNewborn = centimetres(50.0);
    constexpr Length kSchoolChild = centimetres(116.0);
    const Windpipe school = childsAt(kSchoolChild);
    const double grown = (height - kNewborn) / (kSchoolChild - kNewborn);
    const Length cords = mix(centimetres(5.1), school.cordsToCarina, grown);
    const Length toTrachea =
        mix(millimetres(9.2), school.cordsToCarina - school.tracheaLength, grown);
    const Length trachea = cords - toTrachea;
    const Length walls = wallsOf(trachea);
    const Length sagittal = 0.0070 * height + centimetres(0.05) + walls;
    const Length coronal = 0.0065 * height + centimetres(0.18) + walls;
    return {cords,
            trachea,
            sagittal,
            coronal,
            {sagittal, coronal},
            (kMan.rightBronchus / kMan.cordsToCarina) * cords};
}

Windpipe between(const Windpipe& a, const Windpipe& b, double share)
{
    return {mix(a.cordsToCarina, b.cordsToCarina, share),
            mix(a.tracheaLength, b.tracheaLength, share),
            mix(a.sagittal, b.sagittal, share),
            mix(a.coronal, b.coronal, share),
            {mix(a.upper.sagittal, b.upper.sagittal, share),
             mix(a.upper.coronal, b.upper.coronal, share)},
            mix(a.rightBronchus, b.rightBronchus, share)};
}

Windpipe windpipeOf(const PatientParameters& p)
{
    const Windpipe child = childsAt(p.height);
    if (p.ageInYears < kSchoolAge_years)
        return between(infantsAt(p.height), child, leftInfancy(p.ageInYears));
    const Windpipe grown =
        p.sex == Sex::Male ? kMan.at(p.height, kMansHeight) : kWoman.at(p.height, kWomansHeight);
    return between(child, grown, maturity(p));
}

/// Children of any age 0.12 h + 5.2 cm (170 children, R 0.98, Anesthesiology 2008;108:1004), which
/// is 11.2 cm in a newborn of 50 cm; grown men
/// 11.413 + 0.072 h and women 13.555 + 0.056 h cm (Gomez 2016).
Length teethToCarinaOf(const PatientParameters& p)
{
    const Length child = 0.12 * p.height + centimetres(5.2);
    const Length grown = p.sex == Sex::Male ? 0.072 * p.height + centimetres(11.413)
                                            : 0.056 * p.height + centimetres(13.555);
    return mix(child, grown, maturity(p));
}

constexpr double kAirwayScatter = 0.15; ///< see LengthRange

LengthRange rangeAbout(Length usual)
{
    return {(1.0 - kAirwayScatter) * usual, (1.0 + kAirwayScatter) * usual};
}

/// Scales the lengths of the airway from the usual to the measured one.
Result<void> setTeethToCarina(Length measured, PatientDimensions& d)
{
    const LengthRange range = rangeAbout(d.teethToCarina);
    if (!(measured >= range.least && measured <= range.most))
        return fail(Errc::OutOfRange,
                    "teeth to carina are " + std::to_string(std::lround(inMillimetres(range.least)))
                        + " to " + std::to_string(std::lround(inMillimetres(range.most)))
                        + " mm in a patient of this age, height and sex");
    const double scale = measured / d.teethToCarina;
    for (Length* length : {&d.cordsToCarina, &d.tracheaLength, &d.rightBronchus.length,
                           &d.leftBronchus.length, &d.teethToCarina})
        *length = scale * *length;
    return {};
}

/// Weight, lungs and the fat below the skin.
void addBody(const PatientParameters& p, PatientDimensions& d)
{
    d.ageInYears = p.ageInYears;
    d.sex = p.sex;
    d.height = p.height;
    const double usual = usualBodyMassIndex(p.ageInYears) * p.height.si * p.height.si;
    const bool obese = p.habitus == Habitus::Obese;
    // 127 kg is the obese patient of Benumof's curves, 1.65 times the standard one of that height.
    d.weightInKilograms = usual * (obese ? 1.65 : p.habitus == Habitus::Slim ? 0.8 : 1.0);
    d.functionalResidualCapacity = lungVolumesOf(buildOf(d)).functionalResidual;
    d.rightLungShare = 0.525; // Pulse
    // CT of 32 people lying gives 17.9, 9.3, 26.5, 23.1 and 23.2 % (PMC7490509), one man's
    // published surfaces 23.4, 9.9, 21.4, 21.6 and 23.7 %. These are within 3 of both.
    d.lobes = {0.207, 0.082, 0.236, 0.237, 0.238};
    d.fatness = obese ? 1.0 : 0.0;
    d.fatLayer = millimetres(obese ? 38.0 : p.habitus == Habitus::Slim ? 7.0 : 14.0);
    if (p.ageInYears < 14.0)
        d.fatLayer = 0.7 * d.fatLayer;
    // Of ours: in proportion to a small body.
    d.fatLayer = mix(0.4, 1.0, shareBetween(0.0, kSchoolAge_years, p.ageInYears)) * d.fatLayer;
}

/// Women's vocal folds are 12.7 (2.3) mm long, men's 14.8 (3.0) mm (Jibi Inkoka Keibu 125(6)),
/// their open glottis 17 and 23 mm (Miller, 6th edition); the sexes are alike before puberty
/// (Wysocki 2008). 0.81 lies between both; for a larynx that is as high as the woman's.
double larynxGirthOf(const PatientParameters& p)
{
    constexpr double kBreadth = 0.81;
    constexpr double kHeight =
        (kWoman.cordsToCarina - kWoman.tracheaLength) / (kMan.cordsToCarina - kMan.tracheaLength);
    return p.sex == Sex::Male ? 1.0 : mix(1.0, kBreadth / kHeight, maturity(p));
}

std::string inWholeCentimetres(Length length)
{
    return std::to_string(std::lround(0.1 * inMillimetres(length)));
}

double ofMonths(double months) { return months / 12.0; }

} // namespace

Length usualTube(double age, Sex sex)
{
    if (age < kSchoolAge_years)
        return millimetres(age < ofMonths(8.0) ? 3.0 : age < 2.0 ? 3.5 : age < 4.0 ? 4.0 : 4.5);
    const double grown = sex == Sex::Male ? 8.0 : 7.0;
    const bool isGrown = maturity({age, {}, sex, Habitus::Normal, {}}) >= 0.5;
    const double inner = isGrown ? grown : std::min(age / 4.0 + 3.5, 7.0);
    return millimetres(0.5 * std::round(2.0 * inner));
}

LengthRange heightRange(double age)
{
    if (age >= kSchoolAge_years)
        return {kLeastHeight, kGreatestHeight};
    constexpr std::array<std::array<double, 2>, 3> kLeast_m{
        {{0.0, 0.45}, {1.0, 0.65}, {kSchoolAge_years, kLeastHeight.si}}};
    constexpr std::array<std::array<double, 2>, 3> kMost_m{
        {{0.0, 0.60}, {1.0, 0.90}, {kSchoolAge_years, 1.40}}};
    // A line that meets a whole centimetre may miss it by rounding.
    constexpr double kRounding_cm = 1e-6;
    const double least_cm = std::ceil(100.0 * onLines(kLeast_m, age) - kRounding_cm);
    const double most_cm = std::floor(100.0 * onLines(kMost_m, age) + kRounding_cm);
    return {metres(least_cm / 100.0), metres(most_cm / 100.0)};
}

double usualBodyMassIndex(double age)
{
    constexpr double kTwelve = 40.0 / (1.5 * 1.5);
    constexpr double kGrown = 77.0 / (1.75 * 1.75);
    constexpr double kAtSchoolAge = kTwelve - 0.3 * (12.0 - kSchoolAge_years);
    constexpr std::array<std::array<double, 2>, 7> kYoung{{{0.0, 13.3},
                                                           {0.25, 16.6},
                                                           {0.5, 17.1},
                                                           {1.0, 16.6},
                                                           {2.0, 15.8},
                                                           {4.0, 15.3},
                                                           {kSchoolAge_years, kAtSchoolAge}}};
    if (age < kSchoolAge_years)
        return onLines(kYoung, age);
    return age < 12.0 ? kTwelve - 0.3 * (12.0 - age)
                      : mix(kTwelve, kGrown, shareBetween(12.0, 18.0, age));
}

PatientParameters parametersOf(BuiltinPatient patient)
{
    switch (patient) {
    case BuiltinPatient::Adult:
        return {30.0, kMansHeight, Sex::Male, Habitus::Normal, {}};
    case BuiltinPatient::TwelveYears:
        return {12.0, kChildsHeight, Sex::Male, Habitus::Normal, {}};
    }
    CARINA_EXPECTS(false);
    return {};
}

Result<PatientDimensions> dimensionsFor(const PatientParameters& p)
{
    if (!(p.ageInYears >= kYoungest_years && p.ageInYears <= kOldest_years))
        return fail(Errc::OutOfRange, "an age is 0 to 90 years");
    if (const LengthRange heights = heightRange(p.ageInYears);
        !(p.height >= heights.least && p.height <= heights.most))
        return fail(Errc::OutOfRange,
                    "a height is " + inWholeCentimetres(heights.least) + " to "
                        + inWholeCentimetres(heights.most) + " cm"
                        + (p.ageInYears < kSchoolAge_years ? " at this age" : ""));
    PatientDimensions d;
    const Windpipe windpipe = windpipeOf(p);
    d.cordsToCarina = windpipe.cordsToCarina;
    d.larynxGirth = larynxGirthOf(p);
    d.tracheaLength = windpipe.tracheaLength;
    d.tracheaSagittal = windpipe.sagittal;
    d.tracheaCoronal = windpipe.coronal;
    d.upperTrachea = windpipe.upper;
    d.tracheaRings = 18; // 16 to 20 in textbooks of anatomy
    // 26.9 (7.0) and 46.2 (8.0) degrees; 2.5 and 5 cm long in adults (AccessAnesthesiology). The
    // right one is the wider; diameters by the ratio of a usual drawing to the mean of the trachea.
    const Length trachea = 0.5 * (windpipe.sagittal + windpipe.coronal);
    d.rightBronchus = {windpipe.rightBronchus, degrees(26.9), 0.78 * trachea};
    d.leftBronchus = {2.0 * windpipe.rightBronchus, degrees(46.2), 0.68 * trachea};
    d.teethToCarina = teethToCarinaOf(p);
    if (p.teethToCarina)
        if (const auto set = setTeethToCarina(*p.teethToCarina, d); !set)
            return tl::unexpected(set.error());
    addBody(p, d);
    d.tubeInnerDiameter = usualTube(p.ageInYears, p.sex);
    return d;
}

Result<LengthRange> teethToCarinaRange(PatientParameters parameters)
{
    parameters.teethToCarina.reset();
    return dimensionsFor(parameters).map([](const PatientDimensions& usual) {
        return rangeAbout(usual.teethToCarina);
    });
}

PatientDimensions dimensionsOf(BuiltinPatient patient)
{
    return dimensionsFor(parametersOf(patient)).value();
}

} // namespace carina
