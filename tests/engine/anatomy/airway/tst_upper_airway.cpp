#include "engine/anatomy/airway/airway_shapes.h"
#include "engine/anatomy/larynx/larynx_frame.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "tests/engine/anatomy/shapes/section.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace carina::upper_airway_test
{
namespace
{

constexpr double kMillimetre = 1e-3;
constexpr double kVoxel = 1.3 * kMillimetre;

struct Person {
    PatientParameters who;
    Anatomy anatomy;
    PatientDimensions dimensions;
};

/// By the name of a row.
const Person& personCalled(const std::string& name)
{
    static const std::map<std::string, PatientParameters> kPeople{
        {"man", {30.0, metres(1.75), Sex::Male, Habitus::Normal, {}}},
        {"woman", {30.0, metres(1.62), Sex::Female, Habitus::Normal, {}}},
        {"12 years", {12.0, metres(1.50), Sex::Male, Habitus::Normal, {}}},
        {"6 years", {6.0, metres(1.16), Sex::Male, Habitus::Normal, {}}}};
    static std::map<std::string, Person> made;
    const auto found = made.find(name);
    if (found != made.end())
        return found->second;
    const PatientParameters& who = kPeople.at(name);
    return made.emplace(name, Person{who, patientFor(who).value(), dimensionsFor(who).value()})
        .first->second;
}

const TriangleMesh& named(const Person& person, const std::string& name)
{
    return std::ranges::find(person.anatomy.parts, name, &AnatomyPart::name)->levels[0];
}

/// The axes of the larynx in A: its origin lies between the cords.
struct Axes {
    Vec3 up;
    Vec3 back;
    Vec3 cords;

    explicit Axes(const Person& person)
        : up(person.anatomy.landmarks.p_A_glottis.normalized()),
          back(up.cross(Vec3::UnitX()).normalized()),
          cords(person.anatomy.landmarks.p_A_glottis)
    {
        if (back.y() < 0.0)
            back = -back;
    }
    [[nodiscard]] Vec3 place(double x_mm, double y_mm, double z_mm) const
    {
        return cords + kMillimetre * (x_mm * Vec3::UnitX() + y_mm * back + z_mm * up);
    }
};

/// How far a place is from a closed surface; negative inside it.
double distanceOutside(const SurfaceTree& surface, const Vec3& p_A)
{
    const SurfacePoint nearest = surface.nearestTo(p_A).value();
    const double distance = (nearest.p - p_A).norm();
    return nearest.normal.dot(p_A - nearest.p) < 0.0 ? -distance : distance;
}

bool isSoft(const AnatomyPart& part)
{
    return part.role == PartRole::Tongue || part.role == PartRole::Epiglottis
           || part.role == PartRole::Mucosa || part.role == PartRole::LaryngealMucosa
           || part.role == PartRole::VocalFold || part.role == PartRole::Pharynx
           || part.role == PartRole::Skull || part.role == PartRole::Spine;
}

double extentAlong(const TriangleMesh& mesh, const Vec3& axis)
{
    const auto [low, high] = std::ranges::minmax(
        mesh.positions, {}, [&](const Vec3f& p) { return p.cast<double>().dot(axis); });
    return (high - low).cast<double>().dot(axis);
}

/// The air between the cords in the midline: from the anterior commissure to its back, metres along
/// `back` from the landmark.
struct MidlineGap {
    double front = 0.0;
    double back = 0.0;
};
MidlineGap glottisOf(const Person& person)
{
    constexpr double kStep = 0.1 * kMillimetre;
    constexpr double kFar = 30.0 * kMillimetre;
    const Axes axes{person};
    const std::array walls{SurfaceTree{named(person, "Laryngeal mucosa")},
                           SurfaceTree{named(person, "Left vocal fold")},
                           SurfaceTree{named(person, "Right vocal fold")}};
    const auto isAir = [&](double y) {
        return std::ranges::all_of(walls, [&](const SurfaceTree& wall) {
            return distanceOutside(wall, axes.cords + y * axes.back) > 0.0;
        });
    };
    MidlineGap gap;
    while (gap.front > -kFar && isAir(gap.front))
        gap.front -= kStep;
    while (gap.back < kFar && isAir(gap.back))
        gap.back += kStep;
    return gap;
}

} // namespace

/// The upper airway as a laryngoscope shows it, held against published sizes.
class TestUpperAirway : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void glottisIsAVOfItsLength_data();
    void glottisIsAVOfItsLength();
    void vestibularFoldsLieAboveAndBesideTheCords_data() { people(); }
    void vestibularFoldsLieAboveAndBesideTheCords();
    void epiglottisIsALeafOfItsSize();
    void piriformFossaeAreAsHigh();
    void throatIsOneCavity_data() { people(); }
    void throatIsOneCavity();
    void larynxLiesHigherInAChild_data();
    void larynxLiesHigherInAChild();
    void atlasLiesBehindThePalate_data() { people(); }
    void atlasLiesBehindThePalate();
    void nothingClosesTheTracheaBelowTheCords();
    void upperTeethStandInTheMaxilla_data() { people(); }
    void upperTeethStandInTheMaxilla();
    void fatNarrowsTheThroat();

private:
    static void people()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"man", "woman", "12 years", "6 years"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
};

void TestUpperAirway::glottisIsAVOfItsLength_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("length_mm");
    QTest::addColumn<double>("tolerance_mm");
    // Open glottis 23 and 17 mm (Miller, 6th edition). Boys: membranous part 4.9 mm below 1 year to
    // 14.0 at 17, of which 12 and 6 years lie on a straight line; 60 % of the whole.
    QTest::newRow("man") << "man" << 23.0 << 1.5;
    QTest::newRow("woman") << "woman" << 17.0 << 2.0;
    QTest::newRow("12 years") << "12 years" << (4.9 + 11.5 / 16.5 * 9.1) / 0.6 << 2.0;
    QTest::newRow("6 years") << "6 years" << (4.9 + 5.5 / 16.5 * 9.1) / 0.6 << 2.0;
}

void TestUpperAirway::glottisIsAVOfItsLength()
{
    QFETCH(QString, name);
    QFETCH(double, length_mm);
    QFETCH(double, tolerance_mm);
    const Person& person = personCalled(name.toStdString());
    const MidlineGap gap = glottisOf(person);
    const double length = (gap.back - gap.front) / kMillimetre;
    QVERIFY2(std::abs(length - length_mm) < tolerance_mm, qPrintable(QString::number(length)));
    // Apart by 6 to 12 mm in grown people (Miller), widest behind the middle, closed in front.
    const Axes axes{person};
    double widest = 0.0;
    double widestAt = 0.0;
    const test::Section cord =
        test::sectionOf(named(person, "Left vocal fold"), {axes.cords, axes.up});
    for (double y = gap.front; y < 0.5 * gap.back; y += 0.5 * kMillimetre) {
        double inner = 1.0;
        for (const Vec3& p : cord.points)
            if (std::abs((p - axes.cords).dot(axes.back) - y) < 0.6 * kMillimetre)
                inner = std::min(inner, p.x());
        if (inner < 1.0 && 2.0 * inner > widest) {
            widest = 2.0 * inner;
            widestAt = y;
        }
    }
    const double size = length / 23.0;
    QVERIFY2(widest > 6.0 * size * kMillimetre && widest < 12.0 * size * kMillimetre,
             qPrintable(QString::number(1e3 * widest)));
    QVERIFY(widestAt > 0.5 * (gap.front + gap.back));
}

/// Seen from above the cords are not hidden by the folds over them, which part by more.
void TestUpperAirway::vestibularFoldsLieAboveAndBesideTheCords()
{
    QFETCH(QString, name);
    const Person& person = personCalled(name.toStdString());
    const Axes axes{person};
    for (const char* side : {"Left ", "Right "}) {
        const Vec3 cord = boundsOf(named(person, std::string{side} + "vocal fold")).centre();
        const Vec3 fold = boundsOf(named(person, std::string{side} + "vestibular fold")).centre();
        QVERIFY((fold - cord).dot(axes.up) > 3.0 * kMillimetre * person.dimensions.larynxGirth
                                                 * person.dimensions.cordsToCarina.si / 0.127);
        const auto inner = [&](const char* part) {
            double least = 1.0;
            for (const Vec3f& p : named(person, std::string{side} + part).positions)
                if (std::abs((p.cast<double>() - axes.cords).dot(axes.back)) < kMillimetre)
                    least = std::min(least, std::abs(double(p.x())));
            return least;
        };
        QVERIFY(inner("vestibular fold") > inner("vocal fold") + kMillimetre);
    }
}

/// 29.1 +- 0.5 and 22.2 +- 0.6 mm in 22 embalmed grown people (Vadgaonkar 2024), of both sexes; a
/// man's is drawn, and a voxel is more than their scatter. The width is that of a flat leaf.
void TestUpperAirway::epiglottisIsALeafOfItsSize()
{
    const Person& man = personCalled("man");
    const Axes axes{man};
    const TriangleMesh& leaf = named(man, "Epiglottis");
    QVERIFY(std::abs(extentAlong(leaf, axes.up) - 29.1 * kMillimetre) < kVoxel);
    const double across = extentAlong(leaf, Vec3::UnitX());
    QVERIFY(across < 22.2 * kMillimetre + kVoxel);
    QVERIFY(across > 19.0 * kMillimetre);
}

/// 25 mm (Vadgaonkar 2024), from the floor to the edge of the aryepiglottic fold.
void TestUpperAirway::piriformFossaeAreAsHigh()
{
    const Person& man = personCalled("man");
    const Axes axes{man};
    const SurfaceTree lining{named(man, "Pharyngeal mucosa")};
    // Down the fossa until its floor.
    double floor = 0.0;
    for (double z = 8.0; z > -30.0 && floor == 0.0; z -= 0.2)
        if (distanceOutside(lining, axes.place(11.8, 8.5, z)) < 0.0)
            floor = z;
    double edge = 0.0;
    for (const Vec3f& p : named(man, "Left cuneiform tubercle").positions)
        edge = std::max(edge, (p.cast<double>() - axes.cords).dot(axes.up) / kMillimetre);
    QVERIFY2(std::abs(edge - floor - 25.0) < 4.0, qPrintable(QString::number(edge - floor)));
}

/// Nose to oesophagus behind the larynx, and mouth to trachea: air all the way.
void TestUpperAirway::throatIsOneCavity()
{
    QFETCH(QString, name);
    const Person& person = personCalled(name.toStdString());
    std::vector<std::pair<std::string, SurfaceTree>> walls;
    for (const AnatomyPart& part : person.anatomy.parts)
        if (isSoft(part))
            walls.emplace_back(part.name, SurfaceTree{part.levels[0]});
    std::string inTheWay;
    for (const Vec3& p_A : person.anatomy.landmarks.path_A)
        for (const auto& [part, surface] : walls)
            if (!(distanceOutside(surface, p_A) > 0.0))
                inTheWay = part;
    // So high does its curve rise on the flat way to a larynx that lies high.
    QEXPECT_FAIL("6 years", "a child's path touches the soft palate", Continue);
    QVERIFY2(inTheWay.empty(), inTheWay.c_str());
}

void TestUpperAirway::larynxLiesHigherInAChild_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("above");
    QTest::addColumn<QString>("below");
    // C3 to C4 in infants, C5 to C6 in grown people; in between it descends.
    QTest::newRow("man") << "man"
                         << "Fourth"
                         << "Sixth";
    QTest::newRow("woman") << "woman"
                           << "Fourth"
                           << "Sixth";
    QTest::newRow("12 years") << "12 years"
                              << "Fourth"
                              << "Sixth";
    QTest::newRow("6 years") << "6 years"
                             << "Third"
                             << "Fifth";
}

void TestUpperAirway::larynxLiesHigherInAChild()
{
    QFETCH(QString, name);
    QFETCH(QString, above);
    QFETCH(QString, below);
    const Person& person = personCalled(name.toStdString());
    const double glottis = person.anatomy.landmarks.p_A_glottis.z();
    const auto level = [&](const QString& which) {
        return boundsOf(named(person, which.toStdString() + " cervical vertebra")).centre().z();
    };
    QVERIFY(glottis < level(above));
    QVERIFY(glottis > level(below));
}

/// The hard palate's plane runs through the atlas.
void TestUpperAirway::atlasLiesBehindThePalate()
{
    QFETCH(QString, name);
    const Person& person = personCalled(name.toStdString());
    const Box atlas = boundsOf(named(person, "Atlas"));
    const Box palate = boundsOf(named(person, "Hard palate"));
    QVERIFY(atlas.max.z() > palate.min.z());
    QVERIFY(atlas.min.z() < palate.max.z());
}

/// From between the cords down to the carina nothing closes the trachea.
void TestUpperAirway::nothingClosesTheTracheaBelowTheCords()
{
    const Person& man = personCalled("man");
    const Axes axes{man};
    const SurfaceTree trachea{named(man, "Trachea")};
    for (double down = 0.0; down < 0.9 * man.dimensions.cordsToCarina.si; down += kMillimetre)
        QVERIFY(distanceOutside(trachea, axes.cords - down * axes.up) > 4.0 * kMillimetre);
}

void TestUpperAirway::upperTeethStandInTheMaxilla()
{
    QFETCH(QString, name);
    const Person& person = personCalled(name.toStdString());
    const SurfaceTree maxilla{named(person, "Maxilla")};
    for (const AnatomyPart& part : person.anatomy.parts) {
        if (part.role != PartRole::Tooth || part.name.find(" upper ") == std::string::npos)
            continue;
        const Vec3 root = std::ranges::max(part.levels[0].positions, {}, [](const Vec3f& p) {
                              return p.z();
                          }).cast<double>();
        QVERIFY2(distanceOutside(maxilla, root - 3.0 * kMillimetre * Vec3::UnitZ()) < 0.0,
                 part.name.c_str());
    }
}

void TestUpperAirway::fatNarrowsTheThroat()
{
    const auto made = [](Habitus habitus) {
        return patientFor({40.0, metres(1.75), Sex::Male, habitus, {}}).value();
    };
    const Anatomy usual = made(Habitus::Normal);
    const Anatomy obese = made(Habitus::Obese);
    const auto width = [](const Anatomy& anatomy, const char* part) {
        return boundsOf(std::ranges::find(anatomy.parts, part, &AnatomyPart::name)->levels[0])
            .size()
            .x();
    };
    QVERIFY(width(obese, "Tongue") > width(usual, "Tongue") + 2.0 * kMillimetre);
    const auto clear = [](const Anatomy& anatomy) {
        const SurfaceTree lining{
            std::ranges::find(anatomy.parts, "Pharyngeal mucosa", &AnatomyPart::name)->levels[0]};
        return lining.distanceTo(anatomy.landmarks.p_A_glottis
                                 + 0.040 * anatomy.landmarks.p_A_glottis.normalized());
    };
    QVERIFY(clear(obese) < clear(usual));
}

CARINA_TEST(TestUpperAirway)

} // namespace carina::upper_airway_test

#include "tst_upper_airway.moc"
