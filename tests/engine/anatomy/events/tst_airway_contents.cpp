#include "engine/anatomy/events/airway_contents.h"

#include "engine/anatomy/airway/pharynx_place.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/patient/patient_name.h"
#include "tests/engine/anatomy/shapes/people.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace carina::airway_contents_test
{
namespace
{

using enum AirwayEventKind;

constexpr double kTolerance_m = 1e-9;

struct Person {
    Anatomy anatomy;
    UpperAirway airway;
};

/// The patient that these words say.
const Person& personOf(const QString& words)
{
    static std::map<QString, Person> made;
    if (const auto found = made.find(words); found != made.end())
        return found->second;
    Anatomy anatomy = patientFor(patientFromWords(words.toStdString()).value()).value();
    UpperAirway airway = upperAirwayOf(anatomy.parts, anatomy.landmarks).value();
    return made.emplace(words, Person{std::move(anatomy), std::move(airway)}).first->second;
}
const UpperAirway& airwayOf(const QString& words) { return personOf(words).airway; }

/// What of the pharynx' lining is level with a place.
Box pharynxAt(const Anatomy& anatomy, const Vec3& p_A)
{
    constexpr double kLevel_m = 2.5e-3;
    Box box;
    for (const Vec3f& p : test::named(anatomy, "Pharyngeal mucosa").positions)
        if (std::abs(double(p.z()) - p_A.z()) < kLevel_m)
            box.include(p.cast<double>());
    return box;
}

/// The share of the line of the glottis that lies behind the surface of a fluid, in a patient on
/// the back under it.
double coveredShare(const UpperAirway& airway, double severity)
{
    const auto fluids = fluidsIn(airway, {{Blood, severity}});
    if (fluids.size() != 1)
        return 0.0;
    constexpr int kPoints = 1000;
    int covered = 0;
    for (int i = 0; i < kPoints; ++i) {
        const double share = (i + 0.5) / kPoints;
        const Vec3 p_A = airway.p_A_commissure + share * (airway.p_A_notch - airway.p_A_commissure);
        covered += p_A.y() > fluids.front().p_AF.y() ? 1 : 0;
    }
    return double(covered) / kPoints;
}

/// What a closed surface encloses, which is positive if all of it looks outward; 0 for one that is
/// open, or whose normals do not look where its triangles do.
double volumeWithin(const TriangleMesh& mesh)
{
    Vec3 areas = Vec3::Zero();
    double all = 0.0;
    double volume = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const auto corner = [&](int n) { return Vec3{mesh.positions.at(t.at(n)).cast<double>()}; };
        const Vec3 area = 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0));
        areas += area;
        all += area.norm();
        volume += corner(0).dot(area) / 3.0;
        for (const std::uint32_t n : t)
            if (area.norm() > 1e-12 && mesh.normals.at(n).cast<double>().dot(area) <= 0.0)
                return 0.0;
    }
    return areas.norm() < 1e-6 * all ? volume : 0.0;
}

/// To the patient's right of the midplane, and above the cords.
struct Beside {
    double right;
    double up;
};
Beside besideGlottis(const UpperAirway& airway, const Vec3& p_A)
{
    const Vec3 from = p_A - 0.5 * (airway.p_A_commissure + airway.p_A_notch);
    return {-from.x(), from.dot(airway.up_A)};
}

} // namespace

/// What lies in the throat of grown people and children.
class TestAirwayContents : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void standsHigherWithTheSeverity_data() { people(); }
    void standsHigherWithTheSeverity();
    void coversHalfOfTheGlottisAtTheWorst_data() { people(); }
    void coversHalfOfTheGlottisAtTheWorst();
    void hasAFlatSurfaceFromTheLarynxToThePalate_data() { people(); }
    void hasAFlatSurfaceFromTheLarynxToThePalate();
    void isClosed();
    void ripplesOnItsSurface();
    void tiltsLittleFromCornerToCorner();
    void hasEachFluidAtItsOwnLevel();
    void standsInAPoolWithinThePharynx_data();
    void standsInAPoolWithinThePharynx();
    void reachesFartherUpTheDeeperItIs();
    void closesItsPoolInTheVallecula();
    void fillsTheValleculaWithTheSeverity_data() { people(); }
    void fillsTheValleculaWithTheSeverity();
    void liesBesideTheLarynxAndThenOverTheGlottis_data() { people(); }
    void liesBesideTheLarynxAndThenOverTheGlottis();
    void liesWithinThePharynx_data() { people(); }
    void liesWithinThePharynx();
    void hasNothingWithoutAnEventOrALarynx();

private:
    static void people()
    {
        QTest::addColumn<QString>("who");
        for (const char* words : {"adult", "child", "6 years, 116 cm, boy", "1 year, 75 cm, girl",
                                  "newborn, 50 cm, girl"})
            QTest::newRow(words) << QString::fromLatin1(words);
    }
};

// To the front, which is up in who lies on the back, evenly, and past the notch at 0.375.
void TestAirwayContents::standsHigherWithTheSeverity()
{
    QFETCH(const QString, who);
    const UpperAirway& airway = airwayOf(who);
    for (const AirwayEventKind kind : kThroatFluids) {
        const auto behindNotch = [&](double severity) {
            const auto fluids = fluidsIn(airway, {{kind, severity}});
            return fluids.size() == 1 && fluids.front().kind == kind
                       ? (fluids.front().p_AF - airway.p_A_notch).y()
                       : 1.0;
        };
        QVERIFY(std::abs(behindNotch(0.375)) < kTolerance_m);
        QVERIFY(behindNotch(0.125) > 0.0);
        const double step = behindNotch(0.125) - behindNotch(0.375);
        QVERIFY(std::abs(behindNotch(0.375) - behindNotch(0.625) - step) < kTolerance_m);
        QVERIFY(std::abs(behindNotch(0.625) - behindNotch(0.875) - step) < kTolerance_m);
    }
}

void TestAirwayContents::coversHalfOfTheGlottisAtTheWorst()
{
    QFETCH(const QString, who);
    const UpperAirway& airway = airwayOf(who);
    QCOMPARE(coveredShare(airway, 0.3), 0.0);
    double last = 0.0;
    for (const double severity : {0.5, 0.75, 1.0}) {
        const double covered = coveredShare(airway, severity);
        QVERIFY(covered > last);
        last = covered;
    }
    QVERIFY2(last > 0.4 && last < 0.7, qPrintable(QString::number(last)));
}

void TestAirwayContents::hasAFlatSurfaceFromTheLarynxToThePalate()
{
    QFETCH(const QString, who);
    const UpperAirway& airway = airwayOf(who);
    const ThroatContent fluid = fluidsIn(airway, {{Vomit, 0.5}}).front();
    Box box;
    for (const Vec3f& p_F : fluidMesh().positions)
        box.include(fluid.p_AF + fluid.size * p_F.cast<double>());
    QCOMPARE(box.min.y(), fluid.p_AF.y());
    QVERIFY(box.min.z() < airway.p_A_notch.z() - 0.005 * airway.size());
    QVERIFY(box.max.z() > airway.p_A_uvula.z());
    QVERIFY(std::abs(box.centre().x() - airway.p_A_notch.x()) < 1e-6);
    QVERIFY(box.max.x() - box.min.x() > 0.03 * airway.size()); // both piriform fossae
}

// The sum of the areas of a closed surface, each along its normal, is nothing; and what it encloses
// is positive if all of them look outward.
void TestAirwayContents::isClosed()
{
    const TriangleMesh mesh = fluidMesh();
    Vec3 areas = Vec3::Zero();
    double volume = 0.0;
    double all = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const auto corner = [&](int n) { return Vec3{mesh.positions.at(t.at(n)).cast<double>()}; };
        const Vec3 area = 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0));
        areas += area;
        all += area.norm();
        volume += corner(0).dot(area) / 3.0;
        for (const std::uint32_t n : t)
            QVERIFY(mesh.normals.at(n).cast<double>().dot(area) > 0.0);
    }
    QVERIFY(areas.norm() < 1e-6 * all);
    // 30 mm deep, 93 mm long, and from 26 to about 54 mm wide.
    QVERIFY2(volume > 30e-3 * 93e-3 * 26e-3 && volume < 30e-3 * 93e-3 * 54e-3,
             qPrintable(QString::number(1e6 * volume)));
}

void TestAirwayContents::ripplesOnItsSurface()
{
    const TriangleMesh mesh = fluidMesh();
    QCOMPARE(mesh.normals.size(), mesh.positions.size());
    std::set<float> different;
    for (const Vec3f& normal : mesh.normals) {
        QVERIFY(std::abs(normal.norm() - 1.0F) < 1e-5F);
        if (normal.y() < -0.5F)
            different.insert(normal.x());
    }
    QVERIFY(different.size() > 100);
}

// Normals are interpolated along straight lines between corners. Half a highlight of moist.frag is
// 4 degrees: exp(300 (cos 4 - 1)) = 0.5.
void TestAirwayContents::tiltsLittleFromCornerToCorner()
{
    constexpr double kHalfHighlight_deg = 4.0;
    for (const TriangleMesh& mesh : {fluidMesh(), poolMesh(millimetres(20.0))}) {
        double most_deg = 0.0;
        for (const Triangle& t : mesh.triangles)
            for (int i = 0; i < 3; ++i) {
                const Vec3f& one = mesh.normals.at(t.at(i));
                const Vec3f& next = mesh.normals.at(t.at((i + 1) % 3));
                if (one.y() > -0.5F)
                    continue; // not of the surface
                const double cosine = std::clamp(double(one.dot(next)), -1.0, 1.0);
                most_deg = std::max(most_deg, std::acos(cosine) * 180.0 / std::numbers::pi);
            }
        QVERIFY2(most_deg > 0.5 && most_deg < kHalfHighlight_deg,
                 qPrintable(QString::number(most_deg)));
    }
}

void TestAirwayContents::hasEachFluidAtItsOwnLevel()
{
    const auto fluids = fluidsIn(airwayOf(QStringLiteral("adult")),
                                 {{Secretions, 0.2}, {Blood, 0.6}, {Vomit, 0.4}});
    QCOMPARE(fluids.size(), std::size_t{3});
    QVERIFY(fluids[0].p_AF.y() > fluids[2].p_AF.y() && fluids[2].p_AF.y() > fluids[1].p_AF.y());
}

void TestAirwayContents::standsInAPoolWithinThePharynx_data()
{
    QTest::addColumn<double>("depth_mm");
    for (const double depth_mm : {1.0, 5.0, 12.0, 20.0})
        QTest::newRow(qPrintable(QString::number(depth_mm))) << depth_mm;
}

void TestAirwayContents::standsInAPoolWithinThePharynx()
{
    QFETCH(const double, depth_mm);
    const TriangleMesh mesh = poolMesh(millimetres(depth_mm));
    QVERIFY(volumeWithin(mesh) > 0.0);
    for (const Vec3f& p : mesh.positions) {
        const Vec3 p_mm = 1e3 * p.cast<double>();
        const PharynxSection wall = pharynxSectionAt(p_mm.z());
        QVERIFY(std::abs(p_mm.x()) < wall.halfWidth);
        const double behindNotch_mm = pharynxSectionAt(0.0).back; // where the depth is measured
        QVERIFY(p_mm.y() >= 0.0);
        QVERIFY(p_mm.y() <= std::max(0.1, depth_mm - (behindNotch_mm - wall.back)) + 1e-3);
    }
}

// The wall behind comes forward towards the palate.
void TestAirwayContents::reachesFartherUpTheDeeperItIs()
{
    double last = 0.0;
    for (const double depth_mm : {1.0, 2.0, 4.0, 6.0}) {
        Box box;
        for (const Vec3f& p : poolMesh(millimetres(depth_mm)).positions)
            box.include(p.cast<double>());
        QVERIFY(box.max.z() > last);
        last = box.max.z();
        QVERIFY(std::abs(box.min.z() + kFluidFoot.si) < 1e-6);
    }
}

// Half an ellipsoid.
void TestAirwayContents::closesItsPoolInTheVallecula()
{
    const double radii =
        0.5 * kValleculaPoolWidth.si * 0.5 * kValleculaPoolHeight.si * kValleculaPoolDepth.si;
    const double half = 2.0 / 3.0 * std::numbers::pi * radii;
    const double volume = volumeWithin(valleculaPoolMesh());
    QVERIFY2(volume > 0.93 * half && volume < half, qPrintable(QString::number(volume / half)));
}

// On the front of the epiglottis, above the vallecula's floor and below the free edge.
void TestAirwayContents::fillsTheValleculaWithTheSeverity()
{
    QFETCH(const QString, who);
    const UpperAirway& airway = airwayOf(who);
    const Vec3 way = airway.p_A_epiglottisTip - airway.p_A_vallecula;
    double last = 0.0;
    for (const double severity : {0.1, 0.5, 1.0}) {
        const AirwayEvents events{{Epiglottitis, 1.0}, {Secretions, severity}};
        const auto fluids = valleculaFluidsIn(airway, events);
        QCOMPARE(fluids.size(), std::size_t{1});
        QVERIFY(fluids.front().kind == Secretions);
        QVERIFY(fluids.front().place == ContentPlace::Vallecula);
        QVERIFY(fluids.front().size > last);
        last = fluids.front().size;
        const double up = (fluids.front().p_AF - airway.p_A_vallecula).dot(way) / way.norm();
        const double halfHeight = 0.5 * last * kValleculaPoolHeight.si;
        QVERIFY(up >= halfHeight - kTolerance_m && up + halfHeight < way.norm());
    }
    QVERIFY(valleculaFluidsIn(airway, {{ForeignBody, 1.0}}).empty());
}

void TestAirwayContents::liesBesideTheLarynxAndThenOverTheGlottis()
{
    QFETCH(const QString, who);
    const UpperAirway& airway = airwayOf(who);
    double last = 1.0;
    for (const double severity : {0.01, 0.3, 0.7, 1.0}) {
        const auto solid = foreignBodyIn(airway, {{ForeignBody, severity}});
        QVERIFY(solid.has_value());
        const Beside at = besideGlottis(airway, solid->p_AF);
        QVERIFY(at.right < last);
        QVERIFY(at.up > 0.0);
        last = at.right;
    }
    QVERIFY(std::abs(last) < 1e-6); // in the midplane
    const auto first = foreignBodyIn(airway, {{ForeignBody, 0.01}});
    const double half = 0.5 * kForeignBody.si * first->size;
    QVERIFY(besideGlottis(airway, first->p_AF).right > half); // none of it there
    const auto over = foreignBodyIn(airway, {{ForeignBody, 1.0}});
    QVERIFY(besideGlottis(airway, over->p_AF).up > half); // above the cords
}

/// Its middle is within the walls, and it is less wide than the pharynx.
void TestAirwayContents::liesWithinThePharynx()
{
    QFETCH(const QString, who);
    const Person& person = personOf(who);
    for (const double severity : {0.01, 0.3, 0.7, 1.0}) {
        const auto solid = foreignBodyIn(person.airway, {{ForeignBody, severity}});
        QVERIFY(solid.has_value());
        const Vec3 p_A = solid->p_AF;
        const Box walls = pharynxAt(person.anatomy, p_A);
        QVERIFY(p_A.x() > walls.min.x() && p_A.x() < walls.max.x());
        QVERIFY(p_A.y() < walls.max.y());
        QVERIFY(kForeignBody.si * solid->size < walls.max.x() - walls.min.x());
    }
}

void TestAirwayContents::hasNothingWithoutAnEventOrALarynx()
{
    UpperAirway airway = airwayOf(QStringLiteral("adult"));
    QVERIFY(fluidsIn(airway, {}).empty());
    QVERIFY(fluidsIn(airway, {{Laryngospasm, 1.0}, {Blood, 0.0}}).empty());
    QVERIFY(!foreignBodyIn(airway, {{Vomit, 1.0}, {ForeignBody, 0.0}}));
    airway.p_A_notch = airway.p_A_commissure;
    QVERIFY(fluidsIn(airway, {{Blood, 1.0}}).empty());
    QVERIFY(!foreignBodyIn(airway, {{ForeignBody, 1.0}}));
}

CARINA_TEST(TestAirwayContents)

} // namespace carina::airway_contents_test

#include "tst_airway_contents.moc"
