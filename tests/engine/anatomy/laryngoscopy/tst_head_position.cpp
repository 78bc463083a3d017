#include "engine/anatomy/airway/airway_measure.h"
#include "engine/anatomy/laryngoscopy/upper_airway.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "tests/support/test_class.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>

namespace carina::head_position_test
{
namespace
{

const Anatomy& shut(BuiltinPatient who)
{
    static std::map<BuiltinPatient, Anatomy> made;
    const auto found = made.find(who);
    if (found != made.end())
        return found->second;
    return made.emplace(who, patientFor(parametersOf(who), Posture::Rest).value()).first->second;
}

NeckField neckOf(BuiltinPatient who, const HeadPosition& position)
{
    const AirwayLandmarks& marks = shut(who).landmarks;
    return {marks.p_A_glottis, marks.p_A_incisors, position};
}

AirwayAxes axesOf(BuiltinPatient who, const HeadPosition& position)
{
    const NeckField neck = neckOf(who, position);
    const UpperAirway airway = upperAirwayOf(shut(who).parts, shut(who).landmarks).value();
    return airwayAxes(bent(airway, neck), neck);
}

HeadPosition extendedBy(double deg) { return {{}, degrees(deg)}; }
HeadPosition flexedBy(double deg) { return {degrees(deg), {}}; }

} // namespace

class TestHeadPosition : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void measuresTheAxesOfAStraightAirway();
    void bringsTheMouthNearerToTheLineOfSight();
    void bringsTheLarynxNearerToTheLineOfSight_data() { people(); }
    void bringsTheLarynxNearerToTheLineOfSight();
    void drawsTheAirwayOutAsSingleAdultsAre();
    void keepsThePlacesInTheirOrder_data() { people(); }
    void keepsThePlacesInTheirOrder();
    void isTheSamePlaceSeenFromElsewhere();
    void foldsNothing_data() { people(); }
    void foldsNothing();

private:
    static void people()
    {
        QTest::addColumn<BuiltinPatient>("who");
        QTest::newRow("adult") << BuiltinPatient::Adult;
        QTest::newRow("child") << BuiltinPatient::TwelveYears;
    }
};

// By hand: the glottis 30 degrees below the hard palate, the larynx upright.
void TestHeadPosition::measuresTheAxesOfAStraightAirway()
{
    UpperAirway airway;
    airway.p_A_incisors = {0.0, -0.1, 0.2};
    airway.p_A_commissure = airway.p_A_incisors + 0.09 * Vec3{0.0, std::sqrt(3.0) / 2.0, -0.5};
    airway.p_A_notch = airway.p_A_commissure;
    const AirwayAxes axes = airwayAxes(airway, NeckField{});
    QVERIFY(std::abs(inDegrees(axes.mouthToSight) - 30.0) < 1e-9);
    QVERIFY(std::abs(inDegrees(axes.sightToLarynx) - 60.0) < 1e-9);
}

// The angle that a blade has to make good by compressing the tongue: less, the more the head is
// extended against the neck.
void TestHeadPosition::bringsTheMouthNearerToTheLineOfSight()
{
    const BuiltinPatient who = BuiltinPatient::Adult;
    double last_deg = inDegrees(axesOf(who, {}).mouthToSight);
    for (const double deg : {10.0, 20.0, 30.0}) {
        const double now_deg = inDegrees(axesOf(who, extendedBy(deg)).mouthToSight);
        qInfo("extended by %.0f degrees: %.1f, before %.1f", deg, now_deg, last_deg);
        QVERIFY(now_deg < last_deg);
        last_deg = now_deg;
    }
    QVERIFY(axesOf(who, kSniffing).mouthToSight < axesOf(who, {}).mouthToSight);
}

// Adnet et al (2001): simple extension and the sniffing position both lessen this angle (delta).
void TestHeadPosition::bringsTheLarynxNearerToTheLineOfSight()
{
    constexpr double kLeastGain_deg = 5.0;
    QFETCH(const BuiltinPatient, who);
    const double neutral_deg = inDegrees(axesOf(who, {}).sightToLarynx);
    const double extended_deg = inDegrees(axesOf(who, kHeadExtended).sightToLarynx);
    const double sniffing_deg = inDegrees(axesOf(who, kSniffing).sightToLarynx);
    qInfo("neutral %.1f, extended %.1f, sniffing %.1f", neutral_deg, extended_deg, sniffing_deg);
    QVERIFY(extended_deg < neutral_deg - kLeastGain_deg);
    QVERIFY(sniffing_deg < neutral_deg - kLeastGain_deg);
}

// With the tube fixed at the teeth its tip goes deeper as the neck is flexed, by 5.5 mm in the mean
// of adults, and comes out as it is extended, by 6.3 mm; by up to 33 mm in single ones. Flexed by
// 20 degrees the patient is as the mean; extended, its airway is drawn out by more than the mean.
void TestHeadPosition::drawsTheAirwayOutAsSingleAdultsAre()
{
    constexpr double kMeanFlexed_mm = -5.5;
    constexpr double kMeanExtended_mm = 6.3;
    constexpr double kMost_mm = 33.0;
    constexpr double kTolerance_mm = 0.5;
    const AirwayLandmarks& marks = shut(BuiltinPatient::Adult).landmarks;
    const auto longer_mm = [&](const HeadPosition& position) {
        const NeckField neck = neckOf(BuiltinPatient::Adult, position);
        return inMillimetres(teethToCarina(bent(marks, neck)) - teethToCarina(marks));
    };
    const double flexed_mm = longer_mm(flexedBy(20.0));
    const double extended_mm = longer_mm(kHeadExtended);
    const double flexedWholly_mm = longer_mm(kNeckFlexed);
    qInfo("flexed by 20 degrees %.1f mm, by 35 degrees %.1f mm, extended %.1f mm, sniffing %.1f mm",
          flexed_mm, flexedWholly_mm, extended_mm, longer_mm(kSniffing));
    QVERIFY(std::abs(flexed_mm - kMeanFlexed_mm) < kTolerance_mm);
    QVERIFY(flexedWholly_mm < flexed_mm && flexedWholly_mm > -kMost_mm);
    QVERIFY(extended_mm > kMeanExtended_mm && extended_mm < kMost_mm);
    QCOMPARE(longer_mm({}), 0.0);
}

void TestHeadPosition::keepsThePlacesInTheirOrder()
{
    QFETCH(const BuiltinPatient, who);
    const UpperAirway rest = upperAirwayOf(shut(who).parts, shut(who).landmarks).value();
    for (const HeadPosition& position : {kSniffing, kHeadExtended, flexedBy(-25.0)}) {
        const UpperAirway airway = bent(rest, neckOf(who, position));
        const auto height = [&](const Vec3& p_A) { return airway.up_A.dot(p_A); };
        QVERIFY(height(airway.p_A_epiglottisTip) > height(airway.p_A_vallecula));
        QVERIFY(height(airway.p_A_vallecula) > height(airway.p_A_epiglottisBase));
        QVERIFY(height(airway.p_A_epiglottisBase) > height(airway.p_A_commissure));
        QVERIFY(airway.forward_A().dot(airway.p_A_commissure - airway.p_A_notch) > 0.01);
        // The size of a patient does not depend on how they lie.
        QVERIFY(std::abs(airway.size() - rest.size()) < 1e-12);
    }
}

void TestHeadPosition::isTheSamePlaceSeenFromElsewhere()
{
    const NeckField neck = neckOf(BuiltinPatient::Adult, kSniffing);
    const UpperAirway rest =
        upperAirwayOf(shut(BuiltinPatient::Adult).parts, shut(BuiltinPatient::Adult).landmarks)
            .value();
    const UpperAirway inHead = seenFrom(neck.X_AU().inverse(), bent(rest, neck));
    QVERIFY((inHead.p_A_incisors - rest.p_A_incisors).norm() < 1e-9);
    QVERIFY((inHead.p_A_notch - rest.p_A_notch).norm() > 5e-3);
    QVERIFY(std::abs(inHead.up_A.norm() - 1.0) < 1e-12);
    // Relative to the head the larynx turns by what the head is extended, or nearly.
    QVERIFY(inHead.up_A.dot(rest.up_A) < std::cos(degrees(15.0).si));
}

// All parts in the finest level; the skin of the neck reaches beyond what is promised.
void TestHeadPosition::foldsNothing()
{
    QFETCH(const BuiltinPatient, who);
    for (const HeadPosition& position :
         {kSniffing, HeadPosition{kLeastFlexion, kMostExtension}, HeadPosition{kMostFlexion, {}}}) {
        const NeckField neck = neckOf(who, position);
        double least = 1.0;
        double leastOfSkin = 1.0;
        std::string where;
        for (const AnatomyPart& part : shut(who).parts)
            for (const Vec3f& p : part.levels.front().positions) {
                const Mat3 j =
                    Mat3::Identity() + neckPull<double>(neck.frame(), p.cast<double>()).gradient;
                if (part.role == PartRole::Skin)
                    leastOfSkin = std::min(leastOfSkin, j.determinant());
                else if (j.determinant() < least) {
                    least = j.determinant();
                    where = part.name;
                }
            }
        qInfo("flexion %.0f, extension %.0f: least determinant %.2f (%s), of the skin %.2f",
              inDegrees(position.flexion), inDegrees(position.extension), least, where.c_str(),
              leastOfSkin);
        QVERIFY(least > 0.0);
    }
}

CARINA_TEST(TestHeadPosition)

} // namespace carina::head_position_test

#include "tst_head_position.moc"
