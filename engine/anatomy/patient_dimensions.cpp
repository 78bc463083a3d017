#include "engine/anatomy/patient_dimensions.h"

#include "engine/core/expects.h"

#include <cmath>

namespace carina
{

namespace
{

constexpr Length centimetres(double cm) { return millimetres(10.0 * cm); }

/// Teeth to carina from height, 0.12 h + 5.2 cm: 170 children, R 0.98 (Anesthesiology
/// 2008;108:1004). For the adult it is an extrapolation, which 23 cm at the lip with 2 to 4 cm left
/// above the carina bears out.
Length teethToCarinaFor(Length height) { return 0.12 * height + centimetres(5.2); }

PatientDimensions adult()
{
    PatientDimensions d;
    d.height = centimetres(175.0);
    d.weightInKilograms = 77.0; // Pulse's standard patient
    d.ageInYears = 40.0;
    d.cordsToCarina = centimetres(12.7);         // 12.7 (1.6) cm, Caucasian adults (BJA 2006)
    d.tracheaLength = centimetres(10.1);         // men (Kumari 2019)
    d.tracheaSagittal = millimetres(17.1);       // men, MRI (KJA 1993)
    d.tracheaCoronal = millimetres(15.1);        // men, MRI (KJA 1993)
    d.tracheaRings = 18;                         // 16 to 20 in textbooks of anatomy
    d.rightBronchus.length = centimetres(2.5);   // AccessAnesthesiology
    d.leftBronchus.length = centimetres(5.0);    // AccessAnesthesiology
    d.rightBronchus.fromTrachea = degrees(26.9); // 26.9 (7.0)
    d.leftBronchus.fromTrachea = degrees(46.2);  // 46.2 (8.0)
    d.rightBronchus.diameter = 0.82 * d.tracheaCoronal; // the wider one; ratio of a usual drawing
    d.leftBronchus.diameter = 0.72 * d.tracheaCoronal;
    d.teethToCarina = teethToCarinaFor(d.height);
    d.functionalResidualCapacity = millilitres(2310.0); // 30 ml/kg (Pulse)
    d.rightLungShare = 0.525;                           // Pulse
    d.tidalVolume = millilitres(540.0);                 // 7 ml/kg (Pulse)
    d.breathingRate = perMinute(16.0);                  // Pulse
    d.inspiratoryFraction = 0.375;                      // 0.0125 (f + 4) + 0.125 (Pulse)
    d.tubeInnerDiameter = millimetres(8.0);             // usual for men
    return d;
}

/// A boy or girl of twelve: airways grow alike until fourteen (Griscom and Wohl 1986).
PatientDimensions twelveYears()
{
    const PatientDimensions grown = adult();
    PatientDimensions d = grown;
    d.height = centimetres(150.0);
    d.weightInKilograms = 40.0;
    d.ageInYears = 12.0;
    // Airway lengths go with the 1.3th power of height (exponents 1.22 to 1.37, ARRD 1985).
    const double growth = std::pow(d.height / grown.height, 1.3);
    d.cordsToCarina = growth * grown.cordsToCarina;
    d.tracheaLength = growth * grown.tracheaLength;
    d.rightBronchus.length = growth * grown.rightBronchus.length;
    d.leftBronchus.length = growth * grown.leftBronchus.length;
    d.tracheaSagittal = millimetres(12.3); // mean of the rows for 10-12 and 12-14 years
    d.tracheaCoronal = millimetres(12.6);  // (Griscom and Wohl 1986): nearly round
    d.rightBronchus.diameter = 0.82 * d.tracheaCoronal;
    d.leftBronchus.diameter = 0.72 * d.tracheaCoronal;
    d.teethToCarina = teethToCarinaFor(d.height);
    d.functionalResidualCapacity = millilitres(1200.0); // 30 ml/kg (Pulse, scaled by weight)
    d.tidalVolume = millilitres(280.0);     // 7 ml/kg at every age (Respir Physiol 1981)
    d.breathingRate = perMinute(19.0);      // Fleming 2011
    d.inspiratoryFraction = 0.41;           // 0.0125 (f + 4) + 0.125 (Pulse)
    d.tubeInnerDiameter = millimetres(6.5); // cuffed: age / 4 + 3.5 mm
    return d;
}

} // namespace

PatientDimensions dimensionsOf(BuiltinPatient patient)
{
    switch (patient) {
    case BuiltinPatient::Adult:
        return adult();
    case BuiltinPatient::TwelveYears:
        return twelveYears();
    }
    CARINA_EXPECTS(false);
    return {};
}

} // namespace carina
