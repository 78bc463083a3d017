#include "engine/anatomy/laryngoscopy/upper_airway.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/anatomy/shapes/tube.h"
#include "engine/geometry/mesh/mesh_winding.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "tests/engine/anatomy/shapes/section.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace carina::infant_test
{
namespace
{

constexpr double kMillimetre = 1e-3;

struct Infant {
    PatientDimensions dimensions;
    Anatomy anatomy;
};

/// The patient that these words say.
const Infant& infantCalled(const QString& words)
{
    static std::map<QString, Infant> made;
    const auto found = made.find(words);
    if (found != made.end())
        return found->second;
    const PatientParameters who = patientFromWords(words.toStdString()).value();
    return made.emplace(words, Infant{dimensionsFor(who).value(), patientFor(who).value()})
        .first->second;
}

const TriangleMesh& named(const Infant& infant, const std::string& name)
{
    return std::ranges::find(infant.anatomy.parts, name, &AnatomyPart::name)->levels[0];
}

double distanceOutside(const SurfaceTree& surface, const Vec3& p_A)
{
    const SurfacePoint nearest = surface.nearestTo(p_A).value();
    const double distance = (nearest.p - p_A).norm();
    return nearest.normal.dot(p_A - nearest.p) < 0.0 ? -distance : distance;
}

/// Round an ellipse with this area and this length (Ramanujan).
double roundEllipse(double area, double length)
{
    const double a = 0.5 * length;
    const double b = area / (std::numbers::pi * a);
    return std::numbers::pi * (3.0 * (a + b) - std::sqrt((3.0 * a + b) * (a + 3.0 * b)));
}

/// The largest circumference of the cranium, metres.
double roundTheHead(const Infant& infant)
{
    const TriangleMesh& skin = named(infant, "Skin");
    const double top = boundsOf(skin).max.z();
    const double above = top - infant.anatomy.landmarks.p_A_incisors.z();
    double most = 0.0;
    for (double down = 0.2 * above; down < 0.45 * above; down += 2.0 * kMillimetre) {
        const test::Section section =
            test::sectionOf(skin, {(top - down) * Vec3::UnitZ(), Vec3::UnitZ()});
        const auto [front, back] =
            std::ranges::minmax(section.points, {}, [](const Vec3& p) { return p.y(); });
        most = std::max(most, roundEllipse(std::abs(section.area), back.y() - front.y()));
    }
    return most;
}

} // namespace

/// Patients below six years, held against published sizes.
class TestInfant : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isMadeWhole_data() { people(); }
    void isMadeWhole();
    void hasTheLarynxAtItsVertebra_data();
    void hasTheLarynxAtItsVertebra();
    void hasAGlottisOfPublishedLength();
    void hasAnOmegaForAnEpiglottis();
    void hasALargeHead_data();
    void hasALargeHead();
    void getsItsTeeth_data();
    void getsItsTeeth();
    void leavesRoomForItsTube_data() { people(); }
    void leavesRoomForItsTube();

private:
    static void people()
    {
        QTest::addColumn<QString>("words");
        for (const char* words : {"newborn, 50 cm, girl", "3 months, 60 cm, boy",
                                  "1 year, 75 cm, girl", "3 years, 96 cm, boy"})
            QTest::newRow(words) << QString::fromLatin1(words);
    }
};

/// No surface meets itself, and the lungs hold what they should.
void TestInfant::isMadeWhole()
{
    QFETCH(QString, words);
    const Infant& infant = infantCalled(words);
    double volume = 0.0;
    for (const AnatomyPart& part : infant.anatomy.parts) {
        for (const TriangleMesh& level : part.levels) {
            QVERIFY2(isClosed(level), part.name.c_str());
            QVERIFY2(SurfaceTree{level}.selfIntersections() == 0, part.name.c_str());
        }
        if (lungSide(part.role))
            volume += signedVolume(part.levels.front());
    }
    QVERIFY(std::abs(volume / infant.dimensions.functionalResidualCapacity.si - 1.0) < 0.002);
    QVERIFY(parametersOfHash(infant.anatomy.contentHash).has_value());
}

void TestInfant::hasTheLarynxAtItsVertebra_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("above");
    QTest::addColumn<QString>("below");
    // At the third and fourth cervical vertebra in infants, at the fourth and fifth in children.
    QTest::newRow("newborn") << "newborn, 50 cm, girl"
                             << "Third"
                             << "Fourth";
    QTest::newRow("1 year") << "1 year, 75 cm, girl"
                            << "Third"
                            << "Fourth";
    QTest::newRow("3 years") << "3 years, 96 cm, boy"
                             << "Third"
                             << "Fifth";
}

void TestInfant::hasTheLarynxAtItsVertebra()
{
    QFETCH(QString, words);
    QFETCH(QString, above);
    QFETCH(QString, below);
    const Infant& infant = infantCalled(words);
    const double glottis = infant.anatomy.landmarks.p_A_glottis.z();
    const auto level = [&](const QString& which) {
        return boundsOf(named(infant, which.toStdString() + " cervical vertebra")).centre().z();
    };
    QVERIFY(glottis < level(above));
    QVERIFY(glottis > level(below));
}

/// The membranous part is 4.9 mm long in boys and 4.4 in girls below one year (measuring sticks in
/// vivo), and 60 % of the whole.
void TestInfant::hasAGlottisOfPublishedLength()
{
    constexpr double kTolerance_mm = 1.2;
    for (const auto& [words, membranous_mm] :
         {std::pair{"3 months, 60 cm, boy", 4.9}, std::pair{"newborn, 50 cm, girl", 4.4}}) {
        const Infant& infant = infantCalled(QString::fromLatin1(words));
        const UpperAirway airway =
            upperAirwayOf(infant.anatomy.parts, infant.anatomy.landmarks).value();
        const double length_mm = inMillimetres(airway.glottis());
        QVERIFY2(std::abs(length_mm - membranous_mm / 0.6) < kTolerance_mm,
                 qPrintable(QString::number(length_mm)));
    }
}

/// Its edges are bent back until the leaf is as deep as it is wide, which no grown one is.
void TestInfant::hasAnOmegaForAnEpiglottis()
{
    const auto depthToWidth = [](const Anatomy& anatomy) {
        const auto leaf =
            std::ranges::find(anatomy.parts, PartRole::Epiglottis, &AnatomyPart::role);
        const Vec3 p_A_glottis = anatomy.landmarks.p_A_glottis;
        const Vec3 up = p_A_glottis.normalized();
        const Box box = boundsOf(leaf->levels[0]);
        const Vec3 middle = p_A_glottis + 0.7 * (box.max.z() - p_A_glottis.z()) * up;
        Box section;
        for (const Vec3& p : test::sectionOf(leaf->levels[0], {middle, up}).points)
            section.include(p);
        const Vec3 size = section.max - section.min;
        return size.y() / size.x();
    };
    const double newborn =
        depthToWidth(infantCalled(QStringLiteral("newborn, 50 cm, girl")).anatomy);
    const double man = depthToWidth(builtinPatient(BuiltinPatient::Adult).value());
    QVERIFY2(newborn > 0.5, qPrintable(QString::number(newborn)));
    QVERIFY2(man < 0.35, qPrintable(QString::number(man)));
}

void TestInfant::hasALargeHead_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<double>("round_cm");
    // Medians of WHO's growth standards.
    QTest::newRow("newborn girl") << "newborn, 50 cm, girl" << 33.9;
    QTest::newRow("girl of 1 year") << "1 year, 75 cm, girl" << 44.9;
    QTest::newRow("boy of 3 years") << "3 years, 96 cm, boy" << 49.5;
}

void TestInfant::hasALargeHead()
{
    constexpr double kTolerance = 0.028; // WHO's standard deviations are 2.8 to 3.5 %
    QFETCH(QString, words);
    QFETCH(double, round_cm);
    const double round = roundTheHead(infantCalled(words));
    QVERIFY2(std::abs(100.0 * round / round_cm - 1.0) < kTolerance,
             qPrintable(QString::number(100.0 * round)));
}

void TestInfant::getsItsTeeth_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<int>("teeth");
    // Milk teeth come from the sixth to the thirty-third month (American Dental Association).
    QTest::newRow("newborn") << "newborn, 50 cm, girl" << 0;
    QTest::newRow("3 months") << "3 months, 60 cm, boy" << 0;
    QTest::newRow("1 year, incisors") << "1 year, 75 cm, girl" << 6;
    QTest::newRow("3 years, all") << "3 years, 96 cm, boy" << 20;
}

void TestInfant::getsItsTeeth()
{
    QFETCH(QString, words);
    QFETCH(int, teeth);
    const Infant& infant = infantCalled(words);
    int count = 0;
    for (const AnatomyPart& part : infant.anatomy.parts) {
        if (part.role != PartRole::Tooth)
            continue;
        ++count;
        QVERIFY2(part.name.find("primary") != std::string::npos, part.name.c_str());
    }
    QCOMPARE(count, teeth);
    const UpperAirway airway =
        upperAirwayOf(infant.anatomy.parts, infant.anatomy.landmarks).value();
    QCOMPARE(airway.hasIncisors, teeth > 0);
}

/// A tube that fits lies in the trachea, past its narrowest place. A newborn's is 4.0 mm wide, as
/// the air is deep (Griscom et al.), so that it touches rings, by 0.3 mm at the most.
void TestInfant::leavesRoomForItsTube()
{
    QFETCH(QString, words);
    const Infant& infant = infantCalled(words);
    const SurfaceTree trachea{named(infant, "Trachea")};
    const Vec3 p_A_glottis = infant.anatomy.landmarks.p_A_glottis;
    const double least = 0.5 * outerDiameterOf(infant.dimensions.tubeInnerDiameter).si;
    const Length tip = usualTipAboveCarina(infant.dimensions.tubeInnerDiameter);
    double room = 1.0;
    for (double up = tip.si; up < 0.95 * infant.dimensions.tracheaLength.si; up += kMillimetre)
        room = std::min(room, distanceOutside(trachea, up * p_A_glottis.normalized()));
    QVERIFY2(room > least - 0.3 * kMillimetre, qPrintable(QString::number(1e3 * room)));
    QVERIFY(tip < 0.5 * infant.dimensions.tracheaLength);
}

CARINA_TEST(TestInfant)

} // namespace carina::infant_test

#include "tst_infant.moc"
