#include "engine/anatomy/mouth/fauces_shape.h"
#include "engine/anatomy/patient/patient_name.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <optional>
#include <string>

namespace carina::fauces_shape_test
{
namespace
{

constexpr double kNone = 1e9;

/// A patient's shapes, before they are meshed.
struct Person {
    BodyPlan plan;
    LarynxFrame larynx;
    ThroatAir air;
    Tongue tongue;
    Fauces fauces;

    explicit Person(const QString& words)
        : plan(bodyPlanOf(dimensionsFor(patientFromWords(words.toStdString()).value()).value(),
                          Posture::Laryngoscopy)),
          larynx(plan.dimensions),
          air(plan, larynx),
          tongue(plan, larynx, Epiglottis{plan}),
          fauces(plan, larynx, tongue)
    {
    }

    [[nodiscard]] double arch(bool isFront, const Vec3& p_mm) const
    {
        const Vec3 p_A = plan.inThroat(p_mm);
        return (isFront ? fauces.palatoglossalArch(p_A) : fauces.palatopharyngealArch(p_A))
               / plan.face;
    }
    [[nodiscard]] double palate(const Vec3& p_mm) const
    {
        return fauces.softPalate(plan.inThroat(p_mm)) / plan.face;
    }
};

/// The place of an arch that is nearest to the midplane at a height, in reference millimetres.
std::optional<Vec3> edgeAt(const Person& person, bool isFront, double z)
{
    const double from = isFront ? 38.0 : 58.0;
    const double to = isFront ? 64.0 : 74.0;
    std::optional<Vec3> edge;
    for (double y = from; y < to; y += 0.5)
        for (double x = 3.0; x < (edge ? edge->x() : 26.0); x += 0.5)
            if (person.arch(isFront, {x, y, z}) < 0.0)
                edge = Vec3{x, y, z};
    return edge;
}

/// How far a solid reaches in y at an x and a height, in reference millimetres.
template <class Solid> double depthAt(Solid solid, double x, double z, double from, double to)
{
    double least = kNone;
    double most = -kNone;
    for (double y = from; y < to; y += 0.1)
        if (solid(Vec3{x, y, z}) < 0.0) {
            least = std::min(least, y);
            most = std::max(most, y);
        }
    return std::max(most - least, 0.0);
}

} // namespace

/// Soft palate, uvula and arches as one drapery, from the functions that make them.
class TestFaucesShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void archesEndWithinWhatTheyJoin_data() { people(); }
    void archesEndWithinWhatTheyJoin();
    void archesAreThinAndThickenToTheirRoot();
    void backArchProjectsFarther_data() { people(); }
    void backArchProjectsFarther();
    void softPalateHasADoubleArch_data() { people(); }
    void softPalateHasADoubleArch();
    void uvulaGrowsOutOfTheSoftPalate_data() { people(); }
    void uvulaGrowsOutOfTheSoftPalate();

private:
    static void people()
    {
        QTest::addColumn<QString>("words");
        for (const char* words :
             {"adult", "45 years, 165 cm, woman", "child", "6 years, 116 cm, boy",
              "1 year, 75 cm, girl", "newborn, 50 cm, girl"})
            QTest::newRow(words) << QString::fromLatin1(words);
    }
};

/// The palatoglossal arch ends above in the palate and below in the side of the tongue, the
/// palatopharyngeal one in the palate and in the side of the pharynx (Gray 1918): who follows the
/// free edge down finds no end.
void TestFaucesShape::archesEndWithinWhatTheyJoin()
{
    QFETCH(QString, words);
    const Person person{words};
    constexpr double kSlack_mm = 0.6; // the grid of places that are looked at
    constexpr double kStep_mm = 4.0;  // from one height to the next
    for (const bool isFront : {true, false}) {
        const double top = isFront ? 16.5 : 11.5;
        std::optional<Vec3> above;
        bool isFree = false;
        bool isJoined = false;
        for (double z = top; z > -28.0 && !(isFree && isJoined); z -= 1.0) {
            const auto edge = edgeAt(person, isFront, z);
            const std::string where = (isFront ? "front " : "back ") + std::to_string(z);
            QVERIFY2(edge.has_value(), where.c_str());
            const Vec3 p_A = person.plan.inThroat(*edge);
            const double joins =
                std::min(isFront ? person.tongue.distance(p_A) : kNone, -person.air.distance(p_A))
                / person.plan.face;
            if (!above)
                QVERIFY2(person.palate(*edge) < kSlack_mm, where.c_str());
            else if (isFree)
                QVERIFY2(std::abs(edge->x() - above->x()) < kStep_mm, where.c_str());
            isFree = isFree || (joins > 0.0 && person.palate(*edge) > kSlack_mm);
            isJoined = isFree && joins < 0.0;
            above = edge;
        }
        QVERIFY(isFree);
        QVERIFY(isJoined);
    }
}

void TestFaucesShape::archesAreThinAndThickenToTheirRoot()
{
    const Person person{QStringLiteral("adult")};
    for (const bool isFront : {true, false}) {
        const auto depth = [&](double x) {
            return depthAt([&](const Vec3& p) { return person.arch(isFront, p); }, x, 3.0,
                           isFront ? 44.0 : 62.0, isFront ? 60.0 : 78.0);
        };
        const double edge = edgeAt(person, isFront, 3.0)->x();
        double wall = edge;
        const double y = isFront ? 51.5 : 69.9;
        while (person.air.distance(person.plan.inThroat({wall, y, 3.0})) < 0.0)
            wall += 0.1;
        QVERIFY2(wall - edge > 4.0, qPrintable(QString::number(wall - edge))); // a fold
        const double thin = depth(edge + 3.0);
        QVERIFY2(thin > 2.2 * 1.3 && thin < 4.6, qPrintable(QString::number(thin)));
        QVERIFY2(depth(wall) > thin + 1.0, qPrintable(QString::number(depth(wall))));
    }
}

/// The palatopharyngeal arch projects farther towards the midline than the palatoglossal one (Gray
/// 1918), so that both are seen.
void TestFaucesShape::backArchProjectsFarther()
{
    QFETCH(QString, words);
    const Person person{words};
    for (const double z : {6.0, 3.0, 0.0}) {
        const auto front = edgeAt(person, true, z);
        const auto back = edgeAt(person, false, z);
        QVERIFY(front && back);
        QVERIFY2(back->x() < front->x() - 0.5, qPrintable(QString::number(z)));
    }
}

/// Its free edge is highest between the uvula and the arch on each side.
void TestFaucesShape::softPalateHasADoubleArch()
{
    QFETCH(QString, words);
    const Person person{words};
    const auto lowest = [&](double x) {
        for (double z = 0.0; z < 16.0; z += 0.1)
            for (double y = 58.0; y < 74.0; y += 0.5)
                if (person.palate({x, y, z}) < 0.0 || person.arch(false, {x, y, z}) < 0.0)
                    return z;
        return kNone;
    };
    const double beside = lowest(6.5);
    for (const double sign : {1.0, -1.0}) {
        QVERIFY2(lowest(sign * 6.5) < 13.0, qPrintable(QString::number(beside)));
        QVERIFY2(beside > lowest(0.0) + 1.5, qPrintable(QString::number(lowest(0.0))));
        QVERIFY2(beside > lowest(sign * 11.0) + 1.5, qPrintable(QString::number(lowest(11.0))));
    }
}

/// It is wider the higher one looks, from its round tip up to where it is within the palate.
void TestFaucesShape::uvulaGrowsOutOfTheSoftPalate()
{
    QFETCH(QString, words);
    const Person person{words};
    const double unit = std::min(person.plan.face, person.plan.airway);
    const Vec3 root = person.plan.inThroat({0.0, 67.5, 11.0});
    const auto at = [&](double x, double y, double z) {
        return person.fauces.uvula(root + unit * Vec3{x, y, z});
    };
    /// Half its width, so many of its millimetres below its root.
    const auto halfWidth = [&](double below) {
        double most = 0.0;
        for (double y = -4.0; y < 10.0; y += 0.5)
            for (double x = 0.0; x < 8.0; x += 0.1)
                if (at(x, y, -below) < 0.0)
                    most = std::max(most, x);
        return most;
    };
    const double tip = halfWidth(14.5);
    double narrower = tip;
    for (const double below : {11.0, 7.0, 4.0, 1.0}) {
        const double half = halfWidth(below);
        QVERIFY2(half > narrower, qPrintable(QString::number(below)));
        narrower = half;
    }
    QVERIFY2(narrower > 2.5 * tip, qPrintable(QString::number(narrower / tip)));
    QVERIFY(person.fauces.softPalate(root) < 0.0);
    QVERIFY(at(0.0, 0.0, 0.0) < 0.0);
    QVERIFY(at(0.0, 5.0, -17.0) > 0.0); // below the tip
}

CARINA_TEST(TestFaucesShape)

} // namespace carina::fauces_shape_test

#include "tst_fauces_shape.moc"
