#include "engine/anatomy/events/airway_changes.h"

#include "engine/anatomy/chest/chest_region.h"
#include "engine/anatomy/events/airway_contents.h"
#include "engine/anatomy/events/swallow.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "tests/support/deformed_tissue.h"
#include "tests/support/test_class.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace carina::airway_changes_test
{
namespace
{

using test::deformed;

constexpr double kMillimetre = 1e-3;
const Vec3 kMucosa{0.6, 0.2, 0.2}; ///< linear light
constexpr double kRounding = 1e-9;
constexpr double kRounding_mm = 1e-3;    ///< of vertices in single precision
constexpr double kNearly = 0.01;         ///< of light: not to be seen
constexpr double kWidthTolerance = 0.03; ///< in shares; vertices are 0.65 mm apart

/// By the name of a row.
const Anatomy& anatomyOf(const QString& name)
{
    static std::map<QString, Anatomy> made;
    const auto found = made.find(name);
    if (found != made.end())
        return found->second;
    const bool isChild = name.startsWith(QStringLiteral("child"));
    const bool isHeld = name.endsWith(QStringLiteral("held open"));
    const auto who = parametersOf(isChild ? BuiltinPatient::TwelveYears : BuiltinPatient::Adult);
    return made
        .emplace(name, patientFor(who, isHeld ? Posture::Laryngoscopy : Posture::Rest).value())
        .first->second;
}

/// A patient, and how events change it.
struct Person {
    const Anatomy& anatomy;
    UpperAirway airway;

    explicit Person(const QString& name)
        : anatomy(anatomyOf(name)), airway(upperAirwayOf(anatomy.parts, anatomy.landmarks).value())
    {
    }

    [[nodiscard]] AirwayField field(AirwayEventKind kind, double severity) const
    {
        return airwayChanges(airway, {{kind, severity}});
    }
    /// The vertices of a part, changed.
    [[nodiscard]] std::vector<Vec3> verticesOf(const std::string& part,
                                               const AirwayField& changes) const
    {
        const auto found = std::ranges::find(anatomy.parts, part, &AnatomyPart::name);
        const TriangleMesh moved =
            deformed(found->levels.front(), changes, *airwayTissueOf(regionOf(*found)));
        std::vector<Vec3> vertices;
        for (const Vec3f& p : moved.positions)
            vertices.emplace_back(p.cast<double>());
        return vertices;
    }
};

double volumeOf(const TriangleMesh& mesh)
{
    double sum = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const auto corner = [&](int n) { return mesh.positions[t[n]].cast<double>(); };
        sum += corner(0).dot(corner(1).cross(corner(2))) / 6.0;
    }
    return std::abs(sum);
}

/// Least x to the left of the midplane and greatest to the right, of places for which `is` holds:
/// how far apart these are.
double gapBetween(const std::vector<Vec3>& left, const std::vector<Vec3>& right,
                  const std::function<bool(const Vec3&)>& is)
{
    double least = std::numeric_limits<double>::max();
    double greatest = std::numeric_limits<double>::lowest();
    for (const Vec3& p : left)
        if (is(p))
            least = std::min(least, p.x());
    for (const Vec3& p : right)
        if (is(p))
            greatest = std::max(greatest, p.x());
    return least - greatest;
}

/// Between the cords, so far behind the commissure.
double widthOfGlottis(const Person& person, const AirwayField& changes, double share)
{
    const UpperAirway& a = person.airway;
    const Vec3 back = a.p_A_notch - a.p_A_commissure;
    return gapBetween(person.verticesOf("Left vocal fold", changes),
                      person.verticesOf("Right vocal fold", changes), [&](const Vec3& p) {
                          const double there =
                              (p - a.p_A_commissure).dot(back) / back.squaredNorm();
                          return std::abs(there - share) < 0.03;
                      });
}

/// How far the places of a part within a slab across the trachea reach to one direction and back.
double extentOf(const Person& person, const AirwayField& changes, const std::string& part,
                const Vec3& dir_A, double below_m)
{
    const UpperAirway& a = person.airway;
    const Vec3 p_A_level = 0.5 * (a.p_A_commissure + a.p_A_notch) - below_m * a.up_A;
    double least = std::numeric_limits<double>::max();
    double greatest = std::numeric_limits<double>::lowest();
    for (const Vec3& p : person.verticesOf(part, changes))
        if (std::abs((p - p_A_level).dot(a.up_A)) < 2.0 * kMillimetre) {
            least = std::min(least, p.dot(dir_A));
            greatest = std::max(greatest, p.dot(dir_A));
        }
    return greatest - least;
}

/// The farthest that anything of a part goes.
double mostOf(const Person& person, const AirwayField& changes, const std::string& part)
{
    const std::vector<Vec3> made = person.verticesOf(part, {});
    const std::vector<Vec3> moved = person.verticesOf(part, changes);
    double most = 0.0;
    for (std::size_t i = 0; i < made.size(); ++i)
        most = std::max(most, (moved[i] - made[i]).norm());
    return most;
}

/// The mean colour of the vertices of a part that is made in some colour, as linear light.
Vec3 meanLightOf(const Person& person, const AirwayField& changes, const std::string& part,
                 const Vec3& own)
{
    const auto found = std::ranges::find(person.anatomy.parts, part, &AnatomyPart::name);
    const AirwayTissue tissue = *airwayTissueOf(regionOf(*found));
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p_A : person.verticesOf(part, {}))
        sum += airwayLight<double>(changes.frame(), tissue, p_A, own);
    return sum / double(found->levels.front().positions.size());
}

/// How much lighter than others the red of a colour is.
double rednessOf(const Vec3& light) { return light.x() / (light.y() + light.z()); }

/// The mean way of the vertices of a part.
Vec3 meanWayOf(const Person& person, const AirwayField& changes, const std::string& part)
{
    const std::vector<Vec3> made = person.verticesOf(part, {});
    const std::vector<Vec3> moved = person.verticesOf(part, changes);
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < made.size(); ++i)
        sum += moved[i] - made[i];
    return sum / double(made.size());
}

} // namespace

class TestAirwayChanges : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void changesNothingWithoutAnEvent_data() { people(); }
    void changesNothingWithoutAnEvent();
    void movesTheCordsWithTheBreath_data() { people(); }
    void movesTheCordsWithTheBreath();
    void shutsTheCordsInASpasm_data() { people(); }
    void shutsTheCordsInASpasm();
    void leavesTheLineOfTheGlottisInASpasm();
    void swellsTheTongue_data() { people(); }
    void swellsTheTongue();
    void narrowsThePharynx_data() { people(); }
    void narrowsThePharynx();
    void thickensTheEpiglottis_data() { people(); }
    void thickensTheEpiglottis();
    void narrowsTheEntranceOfTheLarynx_data() { people(); }
    void narrowsTheEntranceOfTheLarynx();
    void letsTheEpiglottisFallBack_data() { people(); }
    void letsTheEpiglottisFallBack();
    void movesTheLarynxForwardButNotTheTrachea_data() { people(); }
    void movesTheLarynxForwardButNotTheTrachea();
    void swellsLipsAndTheFrontOfTheTongue_data() { people(); }
    void swellsLipsAndTheFrontOfTheTongue();
    void swellsNoLipsWhereThereAreNone();
    void joinsTheCordsInFront_data() { people(); }
    void joinsTheCordsInFront();
    void joinsMoreOfTheCordsWithTheSeverity();
    void pressesTheLarynxBackUpAndToTheRight_data() { people(); }
    void pressesTheLarynxBackUpAndToTheRight();
    void pressesAnAnteriorLarynxBackToItsPlace();
    void narrowsTheTracheaFromAllSides_data() { people(); }
    void narrowsTheTracheaFromAllSides();
    void movesTheTracheaToTheRightAndKeepsItsEnds_data() { people(); }
    void movesTheTracheaToTheRightAndKeepsItsEnds();
    void keepsTheTracheaOutOfTheLungs();
    void bulgesTheNeckBeforeANarrowTrachea_data() { people(); }
    void bulgesTheNeckBeforeANarrowTrachea();
    void narrowsAFatNeckInsideAndThickensIt_data() { people(); }
    void narrowsAFatNeckInsideAndThickensIt();
    void bringsTheIncisorsForwardAndDown_data() { people(); }
    void bringsTheIncisorsForwardAndDown();
    void leansOneLooseIncisorOutOfTheRow_data() { people(); }
    void leansOneLooseIncisorOutOfTheRow();
    void reddensASwollenEpiglottisAndNotTheCords_data() { people(); }
    void reddensASwollenEpiglottisAndNotTheCords();
    void makesPaleWhatAnAngioOedemaSwells_data() { people(); }
    void makesPaleWhatAnAngioOedemaSwells();
    void swellsReddensAndBlackensByABurn_data() { people(); }
    void swellsReddensAndBlackensByABurn();
    void burnsNoTongueWhereThereIsNone();
    void shutsTheCordsAloneAsASwallowBegins_data() { people(); }
    void shutsTheCordsAloneAsASwallowBegins();
    void raisesTheLarynxInASwallow_data() { people(); }
    void raisesTheLarynxInASwallow();
    void sharesTheRoomOfTheThroat();
    void movesMoreWithTheSeverity_data();
    void movesMoreWithTheSeverity();
    void foldsNowhereWithAllEventsAtOnce_data() { people(); }
    void foldsNowhereWithAllEventsAtOnce();
    void saysWhatASetCannotShow();

private:
    static void people()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"adult", "adult, held open", "child"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
};

void TestAirwayChanges::changesNothingWithoutAnEvent()
{
    QFETCH(QString, name);
    const Person person{name};
    QVERIFY(!airwayChanges(person.airway, {}).isThere());
    AirwayEvents none;
    for (int kind = 0; kind < kAirwayEventKinds; ++kind)
        none.push_back({static_cast<AirwayEventKind>(kind), 0.0});
    QVERIFY(!airwayChanges(person.airway, none).isThere());
}

// 10.1 mm at the widest and 5.7 at the narrowest (Brancatisano 1983), of cords that are made 9 mm
// apart.
void TestAirwayChanges::movesTheCordsWithTheBreath()
{
    QFETCH(QString, name);
    const Person person{name};
    for (const double share : {0.3, 0.45, 0.55}) {
        const double made = widthOfGlottis(person, {}, share);
        const auto breathed = [&](double inspiration) {
            return widthOfGlottis(person, airwayChanges(person.airway, {}, inspiration), share)
                   / made;
        };
        QVERIFY(std::abs(breathed(1.0) - 10.1 / 9.0) < kWidthTolerance);
        QVERIFY(std::abs(breathed(0.0) - 5.7 / 9.0) < kWidthTolerance);
    }
}

void TestAirwayChanges::shutsTheCordsInASpasm()
{
    constexpr double kShut_m = 0.5 * kMillimetre;
    QFETCH(QString, name);
    const Person person{name};
    for (const double share : {0.15, 0.25, 0.35, 0.45, 0.55}) {
        const double made = widthOfGlottis(person, {}, share);
        const auto left = [&](double severity) {
            return widthOfGlottis(person, person.field(AirwayEventKind::Laryngospasm, severity),
                                  share);
        };
        QVERIFY2(left(1.0) < kShut_m, qPrintable(QString::number(1e3 * left(1.0))));
        QVERIFY(left(1.0) > 0.0);
        QVERIFY(std::abs(left(0.5) / made - 0.51) < kWidthTolerance);
    }
}

// What is seen of it is measured on this line, however far apart the cords are.
void TestAirwayChanges::leavesTheLineOfTheGlottisInASpasm()
{
    const Person person{QStringLiteral("adult")};
    const UpperAirway shut =
        changed(person.airway, person.field(AirwayEventKind::Laryngospasm, 1.0));
    QVERIFY((shut.p_A_commissure - person.airway.p_A_commissure).norm() < 1e-12);
    QVERIFY((shut.p_A_notch - person.airway.p_A_notch).norm() < 1e-12);
}

void TestAirwayChanges::swellsTheTongue()
{
    QFETCH(QString, name);
    const Person person{name};
    const auto tongue =
        std::ranges::find(person.anatomy.parts, PartRole::Tongue, &AnatomyPart::role);
    const TriangleMesh& made = tongue->levels.front();
    const AirwayField field = person.field(AirwayEventKind::TongueOedema, 1.0);
    const TriangleMesh swollen = deformed(made, field, AirwayTissue::Throat);
    QVERIFY(volumeOf(swollen) > 1.15 * volumeOf(made));
    const auto top = [](const TriangleMesh& mesh) {
        return std::ranges::max(mesh.positions, {}, [](const Vec3f& p) { return p.z(); }).z();
    };
    QVERIFY(top(swollen) > top(made) + 4.0 * kMillimetre * person.airway.size());
    // Its base takes vallecula and epiglottis to the back.
    const UpperAirway moved = changed(person.airway, field);
    for (const auto place : {&UpperAirway::p_A_vallecula, &UpperAirway::p_A_epiglottisTip})
        QVERIFY((moved.*place - person.airway.*place).dot(person.airway.forward_A())
                < -2.0 * kMillimetre * person.airway.size());
}

// Beside the uvula, and a little below its tip.
void TestAirwayChanges::narrowsThePharynx()
{
    QFETCH(QString, name);
    const Person person{name};
    const UpperAirway& a = person.airway;
    const Vec3 p_A_middle = a.p_A_uvula - 1.0 * kMillimetre * a.size() * a.forward_A()
                            - 3.0 * kMillimetre * a.size() * a.up_A;
    const auto width = [&](const AirwayField& changes) {
        const std::vector<Vec3> wall = person.verticesOf("Pharyngeal mucosa", changes);
        std::vector<Vec3> left;
        std::vector<Vec3> right;
        for (const Vec3& p : wall)
            (p.x() > p_A_middle.x() ? left : right).push_back(p);
        return gapBetween(left, right, [&](const Vec3& p) {
            return std::abs((p - p_A_middle).dot(a.forward_A())) < 2.5 * kMillimetre
                   && std::abs((p - p_A_middle).dot(a.up_A)) < 2.5 * kMillimetre;
        });
    };
    const double swollen = width(person.field(AirwayEventKind::PharyngealSwelling, 1.0));
    QVERIFY2(swollen > 0.25 * width({}), qPrintable(QString::number(1e3 * swollen)));
    QVERIFY2(swollen < 0.65 * width({}), qPrintable(QString::number(1e3 * swollen)));
}

// In the midline, in the middle of its leaf.
void TestAirwayChanges::thickensTheEpiglottis()
{
    QFETCH(QString, name);
    const Person person{name};
    const UpperAirway& a = person.airway;
    const Vec3 leaf = a.p_A_epiglottisTip - a.p_A_epiglottisBase;
    const Vec3 across = Vec3::UnitX().cross(leaf).normalized();
    const auto thickness_mm = [&](const AirwayField& changes) {
        double least = std::numeric_limits<double>::max();
        double greatest = std::numeric_limits<double>::lowest();
        for (const Vec3& p : person.verticesOf("Epiglottis", changes)) {
            const Vec3 from = p - a.p_A_epiglottisBase;
            const double share = from.dot(leaf) / leaf.squaredNorm();
            if (std::abs(p.x() - a.p_A_epiglottisBase.x()) > 2.0 * kMillimetre
                || std::abs(share - 0.62) > 0.06)
                continue;
            least = std::min(least, from.dot(across));
            greatest = std::max(greatest, from.dot(across));
        }
        return 1e3 * (greatest - least) * 29.1e-3 / leaf.norm();
    };
    const double swollen = thickness_mm(person.field(AirwayEventKind::Epiglottitis, 1.0));
    QVERIFY2(thickness_mm({}) < 6.0, qPrintable(QString::number(thickness_mm({}))));
    QVERIFY2(swollen > 9.0 && swollen < 16.0, qPrintable(QString::number(swollen)));
}

void TestAirwayChanges::narrowsTheEntranceOfTheLarynx()
{
    QFETCH(QString, name);
    const Person person{name};
    const auto apart = [&](const AirwayField& changes) {
        const auto middle = [&](const char* part) {
            const std::vector<Vec3> vertices = person.verticesOf(part, changes);
            Vec3 sum = Vec3::Zero();
            for (const Vec3& p : vertices)
                sum += p;
            return Vec3{sum / double(vertices.size())};
        };
        return (middle("Left cuneiform tubercle") - middle("Right cuneiform tubercle")).norm();
    };
    const double swollen = apart(person.field(AirwayEventKind::LaryngealOedema, 1.0));
    QVERIFY2(swollen < 0.75 * apart({}), qPrintable(QString::number(swollen / apart({}))));
    QVERIFY(swollen > 0.0);
}

// It bends above the vallecula, and does not come through the wall behind it.
void TestAirwayChanges::letsTheEpiglottisFallBack()
{
    QFETCH(QString, name);
    const Person person{name};
    const UpperAirway& a = person.airway;
    const AirwayField field = person.field(AirwayEventKind::FloppyEpiglottis, 1.0);
    const UpperAirway fallen = changed(a, field);
    const double size = (a.p_A_epiglottisTip - a.p_A_epiglottisBase).norm() / 29.1e-3;
    const Vec3 way = fallen.p_A_epiglottisTip - a.p_A_epiglottisTip;
    QVERIFY(-way.dot(a.forward_A()) > 11.0 * kMillimetre * size);
    QVERIFY(-way.dot(a.up_A) > 3.0 * kMillimetre * size);
    QVERIFY((fallen.p_A_vallecula - a.p_A_vallecula).norm() < 3.0 * kMillimetre * size);
    QVERIFY((fallen.p_A_epiglottisBase - a.p_A_epiglottisBase).norm() < 0.1 * kMillimetre);
    const auto isBeside = [&](const Vec3& p) {
        return std::abs(p.x() - a.p_A_epiglottisTip.x()) < 4.0 * kMillimetre
               && std::abs((p - fallen.p_A_epiglottisTip).dot(a.up_A)) < 4.0 * kMillimetre;
    };
    double rearmost = std::numeric_limits<double>::lowest();
    for (const Vec3& p : person.verticesOf("Epiglottis", field))
        if (isBeside(p))
            rearmost = std::max(rearmost, -p.dot(a.forward_A()));
    double wall = std::numeric_limits<double>::max();
    for (const Vec3& p : person.verticesOf("Pharyngeal mucosa", field))
        if (isBeside(p) && -(p - a.p_A_epiglottisTip).dot(a.forward_A()) > 0.0)
            wall = std::min(wall, -p.dot(a.forward_A()));
    qInfo("%.1f mm before the wall", 1e3 * (wall - rearmost));
    QVERIFY(rearmost < wall);
}

void TestAirwayChanges::movesTheLarynxForwardButNotTheTrachea()
{
    QFETCH(QString, name);
    const Person person{name};
    const UpperAirway& a = person.airway;
    const AirwayField field = person.field(AirwayEventKind::AnteriorLarynx, 1.0);
    const UpperAirway moved = changed(a, field);
    const auto forward = [&](Vec3 UpperAirway::*place) {
        return (moved.*place - a.*place).dot(a.forward_A()) / (a.glottis() / millimetres(24.5));
    };
    for (const auto place : {&UpperAirway::p_A_commissure, &UpperAirway::p_A_notch})
        QVERIFY2(forward(place) > 6.0 * kMillimetre && forward(place) < 10.0 * kMillimetre,
                 qPrintable(QString::number(1e3 * forward(place))));
    QVERIFY(forward(&UpperAirway::p_A_epiglottisBase) > 3.0 * kMillimetre);
    QVERIFY(forward(&UpperAirway::p_A_vallecula) < 1.5 * kMillimetre);
    QCOMPARE(forward(&UpperAirway::p_A_epiglottisTip), 0.0);
    const auto trachea =
        std::ranges::find(person.anatomy.parts, PartRole::Trachea, &AnatomyPart::role);
    for (const Vec3f& p : trachea->levels.front().positions)
        QVERIFY(airwayPull<double>(field.frame(), AirwayTissue::Larynx, p.cast<double>()).d.norm()
                < 0.1 * kMillimetre);
}

void TestAirwayChanges::swellsLipsAndTheFrontOfTheTongue()
{
    QFETCH(QString, name);
    const Person person{name};
    const UpperAirway& a = person.airway;
    QVERIFY(a.p_A_upperLip && a.p_A_lowerLip);
    QVERIFY((*a.p_A_upperLip - a.p_A_incisors).dot(a.forward_A()) > 0.0);
    QVERIFY(a.p_A_upperLip->z() > a.p_A_lowerLip->z());
    const AirwayField field = person.field(AirwayEventKind::AngioOedema, 1.0);
    for (const char* part : {"Upper lip", "Lower lip", "Tongue"}) {
        const auto found = std::ranges::find(person.anatomy.parts, part, &AnatomyPart::name);
        const TriangleMesh& made = found->levels.front();
        const double grown = volumeOf(deformed(made, field, AirwayTissue::Throat)) / volumeOf(made);
        qInfo("%s: %.2f", part, grown);
        QVERIFY(grown > (found->role == PartRole::Tongue ? 1.02 : 1.3));
    }
    QVERIFY(field.frame().vestibule.closing
            == person.field(AirwayEventKind::LaryngealOedema, 1.0).frame().vestibule.closing);
}

void TestAirwayChanges::swellsNoLipsWhereThereAreNone()
{
    Person person{QStringLiteral("adult")};
    const Vec3 p_A_lip = *person.airway.p_A_upperLip;
    const auto moved = [&] {
        const AirwayField field = person.field(AirwayEventKind::AngioOedema, 1.0);
        return airwayPull<double>(field.frame(), AirwayTissue::Throat, p_A_lip).d.norm();
    };
    QVERIFY(moved() > 3.0 * kMillimetre);
    person.airway.p_A_upperLip.reset();
    person.airway.p_A_lowerLip.reset();
    QVERIFY(moved() < 0.5 * kMillimetre);
    QVERIFY(canShow(person.airway, AirwayEventKind::AngioOedema));
}

// Over the front 60 %: a web of the third of Cohen's four types.
void TestAirwayChanges::joinsTheCordsInFront()
{
    constexpr double kShut_m = 0.5 * kMillimetre;
    QFETCH(QString, name);
    const Person person{name};
    const AirwayField joined = person.field(AirwayEventKind::LaryngealWeb, 1.0);
    for (const double share : {0.15, 0.25, 0.35, 0.45}) {
        const double left = widthOfGlottis(person, joined, share);
        QVERIFY2(left > 0.0 && left < kShut_m, qPrintable(QString::number(1e3 * left)));
    }
    QCOMPARE(widthOfGlottis(person, joined, 0.74), widthOfGlottis(person, {}, 0.74));
}

void TestAirwayChanges::joinsMoreOfTheCordsWithTheSeverity()
{
    constexpr double kShut_m = 0.5 * kMillimetre;
    const Person person{QStringLiteral("adult")};
    const auto left = [&](double severity, double share) {
        return widthOfGlottis(person, person.field(AirwayEventKind::LaryngealWeb, severity), share);
    };
    QVERIFY(left(0.2, 0.18) < kShut_m);
    QCOMPARE(left(0.2, 0.45), widthOfGlottis(person, {}, 0.45));
    QVERIFY(left(0.6, 0.3) < kShut_m);
    QCOMPARE(left(0.6, 0.6), widthOfGlottis(person, {}, 0.6));
    QVERIFY(left(0.1, 0.15) > kShut_m); // not shut yet
}

// +x of A is to the patient's left, +y to the back.
void TestAirwayChanges::pressesTheLarynxBackUpAndToTheRight()
{
    QFETCH(QString, name);
    const Person person{name};
    const UpperAirway& a = person.airway;
    const AirwayField field = person.field(AirwayEventKind::ExternalPressure, 1.0);
    const UpperAirway pressed = changed(a, field);
    const double size = a.glottis() / millimetres(24.5);
    for (const auto place : {&UpperAirway::p_A_commissure, &UpperAirway::p_A_notch}) {
        const Vec3 way = (pressed.*place - a.*place) / size;
        QVERIFY2(way.y() > 3.0 * kMillimetre, qPrintable(QString::number(1e3 * way.y())));
        QVERIFY(way.x() < -3.0 * kMillimetre);
        QVERIFY(way.dot(a.up_A) > 2.0 * kMillimetre);
        QVERIFY(way.norm() < 11.0 * kMillimetre);
    }
    for (const char* cord : {"Left vocal fold", "Right vocal fold"})
        QVERIFY(meanWayOf(person, field, cord).x() < -3.0 * kMillimetre * size);
    QVERIFY((pressed.p_A_vallecula - a.p_A_vallecula).norm() < 2.0 * kMillimetre * size);
    QVERIFY((pressed.p_A_epiglottisTip - a.p_A_epiglottisTip).norm() < 0.1 * kMillimetre);
    QCOMPARE(mostOf(person, field, "Trachea"), 0.0);
}

// So that a glottis that an anterior larynx hides comes into view.
void TestAirwayChanges::pressesAnAnteriorLarynxBackToItsPlace()
{
    const Person person{QStringLiteral("adult")};
    const UpperAirway& a = person.airway;
    const auto forward = [&](const AirwayEvents& events) {
        const UpperAirway moved = changed(a, airwayChanges(a, events));
        return 0.5
               * (moved.p_A_commissure + moved.p_A_notch - a.p_A_commissure - a.p_A_notch)
                     .dot(a.forward_A());
    };
    const double anterior = forward({{AirwayEventKind::AnteriorLarynx, 1.0}});
    const double pressed =
        forward({{AirwayEventKind::AnteriorLarynx, 1.0}, {AirwayEventKind::ExternalPressure, 1.0}});
    QVERIFY2(pressed < 0.6 * anterior, qPrintable(QString::number(pressed / anterior)));
}

// To a quarter of its diameter, both ways: 94 % of its lumen, the third of Cotton's four grades.
void TestAirwayChanges::narrowsTheTracheaFromAllSides()
{
    QFETCH(QString, name);
    const Person person{name};
    const UpperAirway& a = person.airway;
    QVERIFY(a.windpipe);
    const double below = a.windpipeSize() * kNarrowingOfWindpipe.si;
    for (const Vec3& dir_A : {Vec3{Vec3::UnitX()}, a.forward_A()}) {
        const auto share = [&](double severity, double level) {
            const AirwayField field = person.field(AirwayEventKind::TrachealStenosis, severity);
            return extentOf(person, field, "Trachea", dir_A, level)
                   / extentOf(person, {}, "Trachea", dir_A, level);
        };
        QVERIFY2(std::abs(share(1.0, below) - 0.25) < 0.05,
                 qPrintable(QString::number(share(1.0, below))));
        QVERIFY(std::abs(share(0.4, below) - 0.7) < 0.05);
        QVERIFY(share(1.0, below + 14.0 * kMillimetre * a.windpipeSize()) > 0.999);
    }
    const AirwayField field = person.field(AirwayEventKind::TrachealStenosis, 1.0);
    for (const char* part : {"Cricoid cartilage", "Laryngeal mucosa", "Left vocal fold"})
        QCOMPARE(mostOf(person, field, part), 0.0);
}

void TestAirwayChanges::movesTheTracheaToTheRightAndKeepsItsEnds()
{
    QFETCH(QString, name);
    const Person person{name};
    const UpperAirway& a = person.airway;
    const AirwayField field = person.field(AirwayEventKind::TrachealDeviation, 1.0);
    const double size = a.windpipeSize();
    const Vec3 p_A_glottis = 0.5 * (a.p_A_commissure + a.p_A_notch);
    const std::vector<Vec3> made = person.verticesOf("Trachea", {});
    const std::vector<Vec3> moved = person.verticesOf("Trachea", field);
    double most = 0.0;
    for (std::size_t i = 0; i < made.size(); ++i) {
        const Vec3 way = moved[i] - made[i];
        const double below = (p_A_glottis - made[i]).dot(a.up_A) / size;
        QVERIFY(way.x() <= 0.0);
        if (below < 26.0 * kMillimetre || below > 88.0 * kMillimetre)
            QVERIFY(way.norm() < 1.0 * kMillimetre);
        most = std::max(most, -way.x());
    }
    QVERIFY2(most > 12.5 * kMillimetre * size && most < 14.1 * kMillimetre * size,
             qPrintable(QString::number(1e3 * most)));
    QVERIFY(mostOf(person, field, "Oesophagus") > 8.0 * kMillimetre * size);
    QCOMPARE(mostOf(person, field, "Cricoid cartilage"), 0.0);
}

// Lungs do not give way to it.
void TestAirwayChanges::keepsTheTracheaOutOfTheLungs()
{
    const Person person{QStringLiteral("adult")};
    const AirwayField field =
        airwayChanges(person.airway, {{AirwayEventKind::TrachealDeviation, 1.0}});
    const auto lobe =
        std::ranges::find(person.anatomy.parts, PartRole::RightUpperLobe, &AnatomyPart::role);
    const auto isBeside = [](const Vec3& p, const Vec3f& q) {
        return std::abs(p.y() - q.y()) < 5.0 * kMillimetre
               && std::abs(p.z() - q.z()) < 3.0 * kMillimetre;
    };
    double least = std::numeric_limits<double>::max();
    for (const Vec3& p : person.verticesOf("Trachea", field))
        if (p.z() > 20.0 * kMillimetre)
            for (const Vec3f& q : lobe->levels.front().positions)
                if (isBeside(p, q))
                    least = std::min(least, p.x() - q.x());
    qInfo("%.1f mm from the lung", 1e3 * least);
    QVERIFY(least > 0.0);
}

void TestAirwayChanges::bulgesTheNeckBeforeANarrowTrachea()
{
    QFETCH(QString, name);
    const Person person{name};
    const UpperAirway& a = person.airway;
    QVERIFY(a.p_A_neck);
    const AirwayField field = person.field(AirwayEventKind::Goitre, 1.0);
    const Vec3 way = airwayPull<double>(field.frame(), AirwayTissue::Skin, *a.p_A_neck).d;
    QVERIFY(way.dot(a.forward_A()) > 12.0 * kMillimetre * a.windpipeSize());
    const double below = a.windpipeSize() * kNarrowingOfWindpipe.si;
    const auto share = [&](const Vec3& dir_A) {
        return extentOf(person, field, "Trachea", dir_A, below)
               / extentOf(person, {}, "Trachea", dir_A, below);
    };
    QVERIFY(std::abs(share(Vec3::UnitX()) - 0.65) < 0.05);
    QVERIFY(std::abs(share(a.forward_A()) - 1.0) < 1e-6);
    const double aside = meanWayOf(person, field, "Trachea").x();
    QVERIFY(aside < -0.5 * kMillimetre && aside > -5.0 * kMillimetre);
    // Without skin it still narrows the trachea.
    UpperAirway bare = a;
    bare.p_A_neck.reset();
    QVERIFY(canShow(bare, AirwayEventKind::Goitre));
    QVERIFY(airwayChanges(bare, {{AirwayEventKind::Goitre, 1.0}}).isThere());
}

void TestAirwayChanges::narrowsAFatNeckInsideAndThickensIt()
{
    QFETCH(QString, name);
    const Person person{name};
    const UpperAirway& a = person.airway;
    const AirwayField field = person.field(AirwayEventKind::NeckObesity, 1.0);
    QVERIFY(field.frame().pharynx.closing > 0.3);
    QVERIFY(field.frame().pharynx.closing
            < person.field(AirwayEventKind::PharyngealSwelling, 1.0).frame().pharynx.closing);
    const UpperAirway moved = changed(a, field);
    QVERIFY((moved.p_A_vallecula - a.p_A_vallecula).dot(a.forward_A()) < 0.0);
    const Vec3 skinWay = airwayPull<double>(field.frame(), AirwayTissue::Skin, *a.p_A_neck).d;
    QVERIFY(skinWay.dot(a.forward_A()) > 1.0 * kMillimetre);
    const double most = mostOf(person, field, "Skin");
    QVERIFY2(most > 6.0 * kMillimetre && most < 18.0 * kMillimetre,
             qPrintable(QString::number(1e3 * most)));
    // Of fat and swelling together more than of each, and never shut.
    const double both = airwayChanges(a, {{AirwayEventKind::PharyngealSwelling, 1.0},
                                          {AirwayEventKind::NeckObesity, 1.0}})
                            .frame()
                            .pharynx.closing;
    QVERIFY(both > 0.6 && both < 0.8);
}

void TestAirwayChanges::bringsTheIncisorsForwardAndDown()
{
    QFETCH(QString, name);
    const Person person{name};
    const UpperAirway& a = person.airway;
    QVERIFY(a.hasIncisors);
    const AirwayField field = person.field(AirwayEventKind::ProminentIncisors, 1.0);
    const UpperAirway moved = changed(a, field);
    const Vec3 edge = moved.p_A_edge() - a.p_A_edge();
    QVERIFY2(-edge.y() > 5.0 * kMillimetre * a.size() && -edge.y() < 7.0 * kMillimetre * a.size(),
             qPrintable(QString::number(-1e3 * edge.y())));
    QVERIFY(-edge.z() > 1.5 * kMillimetre * a.size());
    QCOMPARE(moved.size(), a.size()); // what is in proportion to the patient stays so
    const double central = mostOf(person, field, "Left upper central secondary incisor tooth");
    QVERIFY(central > 5.0 * kMillimetre * a.size());
    QVERIFY(mostOf(person, field, "Left upper second secondary molar tooth") == 0.0);
    QVERIFY(mostOf(person, field, "Gingiva of upper jaw") > 1.0 * kMillimetre);
}

/// More than the 1 mm of Miller's worst grade in a man, in proportion to the severity; and not
/// farther than the thickness of a tooth.
void TestAirwayChanges::leansOneLooseIncisorOutOfTheRow()
{
    QFETCH(QString, name);
    const Person person{name};
    const UpperAirway& a = person.airway;
    const char* const loose = "Right upper central secondary incisor tooth";
    const AirwayField worst = person.field(AirwayEventKind::FragileTeeth, 1.0);
    const double most_mm = 1e3 * mostOf(person, worst, loose) / a.size();
    QVERIFY2(most_mm > 1.2 && most_mm < 2.0, qPrintable(QString::number(most_mm)));
    const AirwayField half = person.field(AirwayEventKind::FragileTeeth, 0.5);
    QVERIFY(std::abs(1e3 * mostOf(person, half, loose) / a.size() - 0.5 * most_mm) < kRounding_mm);
    for (const char* part : {"Left upper central secondary incisor tooth",
                             "Right upper lateral secondary incisor tooth", "Gingiva of upper jaw"})
        QCOMPARE(mostOf(person, worst, part), 0.0);
    QVERIFY(changed(a, worst).p_A_edge() == a.p_A_edge());
    const AirwayField prominent = person.field(AirwayEventKind::ProminentIncisors, 1.0);
    QVERIFY(mostOf(person, prominent, loose) > 5.0 * kMillimetre * a.size());
}

// Red is what has more of it beside green and blue than mucosa does.
void TestAirwayChanges::reddensASwollenEpiglottisAndNotTheCords()
{
    QFETCH(QString, name);
    const Person person{name};
    double last = rednessOf(kMucosa);
    for (const double severity : {0.3, 0.6, 1.0}) {
        const AirwayField field = person.field(AirwayEventKind::Epiglottitis, severity);
        const double redness = rednessOf(meanLightOf(person, field, "Epiglottis", kMucosa));
        QVERIFY(redness > last);
        last = redness;
        const Vec3 ofCord = meanLightOf(person, field, "Left vocal fold", kMucosa);
        QVERIFY((ofCord - kMucosa).norm() < kNearly);
        QVERIFY((meanLightOf(person, field, "Tongue", kMucosa) - kMucosa).norm() < kRounding);
    }
    QVERIFY(last > 1.5 * rednessOf(kMucosa));
}

void TestAirwayChanges::makesPaleWhatAnAngioOedemaSwells()
{
    QFETCH(QString, name);
    const Person person{name};
    const AirwayField field = person.field(AirwayEventKind::AngioOedema, 1.0);
    for (const char* part : {"Upper lip", "Tongue"}) {
        const Vec3 light = meanLightOf(person, field, part, kMucosa);
        QVERIFY2((light - kMucosa).minCoeff() > 0.0, part);
        QVERIFY2(rednessOf(light) < rednessOf(kMucosa), part);
    }
    QVERIFY((meanLightOf(person, field, "Uvula", kMucosa) - kMucosa).norm() < kRounding);
}

// As the four events that do nothing else, each in part: no vertex is moved otherwise.
void TestAirwayChanges::swellsReddensAndBlackensByABurn()
{
    QFETCH(QString, name);
    const Person person{name};
    const AirwayField burnt = person.field(AirwayEventKind::Burn, 1.0);
    using enum AirwayEventKind;
    const AirwayField swollen = airwayChanges(person.airway, {{TongueOedema, 0.3},
                                                              {PharyngealSwelling, 0.7},
                                                              {Epiglottitis, 0.4},
                                                              {LaryngealOedema, 0.7}});
    for (const char* part : {"Tongue", "Epiglottis", "Uvula", "Left vocal fold"}) {
        QVERIFY2(person.verticesOf(part, burnt) == person.verticesOf(part, swollen), part);
        QVERIFY2(meanLightOf(person, burnt, part, kMucosa).y() < 0.7 * kMucosa.y(), part);
    }
    const auto darkest = [&](const std::string& part, AirwayTissue tissue) {
        double least = 1.0;
        for (const Vec3& p_A : person.verticesOf(part, {}))
            least = std::min(least, airwayLight<double>(burnt.frame(), tissue, p_A, kMucosa).x());
        return least;
    };
    QVERIFY(darkest("Tongue", AirwayTissue::Throat) < 0.25 * kMucosa.x());
    QVERIFY(darkest("Epiglottis", AirwayTissue::Larynx) < 0.25 * kMucosa.x());
    QVERIFY(darkest("Left vocal fold", AirwayTissue::Larynx) > 0.4 * kMucosa.x()); // red alone
}

void TestAirwayChanges::burnsNoTongueWhereThereIsNone()
{
    Person person{QStringLiteral("adult")};
    person.airway.p_A_tongue.reset();
    QVERIFY(canShow(person.airway, AirwayEventKind::Burn));
    const AirwayField field = person.field(AirwayEventKind::Burn, 1.0);
    QVERIFY(mostOf(person, field, "Epiglottis") > 1.0 * kMillimetre);
}

// As in a spasm; what lies above stays.
void TestAirwayChanges::shutsTheCordsAloneAsASwallowBegins()
{
    QFETCH(QString, name);
    const Person person{name};
    const AirwayField begun = person.field(AirwayEventKind::Swallowing, kCordsShutInSwallow);
    const AirwayField spasm = person.field(AirwayEventKind::Laryngospasm, 1.0);
    QVERIFY(person.verticesOf("Left vocal fold", begun)
            == person.verticesOf("Left vocal fold", spasm));
    for (const char* part : {"Uvula", "Tongue", "Hyoid bone", "Trachea", "Skin"})
        QCOMPARE(mostOf(person, begun, part), 0.0);
}

// In shares of a man's glottis, up and to the front; the epiglottis falls back on the way, palate
// and uvula go up and back, and the bones of head and spine stay.
void TestAirwayChanges::raisesTheLarynxInASwallow()
{
    QFETCH(QString, name);
    const Person person{name};
    const UpperAirway& a = person.airway;
    const double size = a.glottis() / millimetres(24.5);
    const AirwayField field = person.field(AirwayEventKind::Swallowing, 1.0);
    const UpperAirway moved = changed(a, field);
    const auto up_mm = [&](const Vec3& way) { return 1e3 * way.dot(a.up_A); };
    const auto forward_mm = [&](const Vec3& way) { return 1e3 * way.dot(a.forward_A()); };
    const Vec3 glottis =
        0.5 * (moved.p_A_commissure + moved.p_A_notch) - 0.5 * (a.p_A_commissure + a.p_A_notch);
    const Vec3 hyoid = meanWayOf(person, field, "Hyoid bone");
    QVERIFY2(up_mm(glottis) > 10.0 * size && up_mm(glottis) < 18.0 * size,
             qPrintable(QString::number(up_mm(glottis) / size)));
    QVERIFY2(forward_mm(glottis) > 4.0 * size && forward_mm(glottis) < 10.0 * size,
             qPrintable(QString::number(forward_mm(glottis) / size)));
    QVERIFY2(up_mm(hyoid) > 5.0 * size && forward_mm(hyoid) > 1.0 * size,
             qPrintable(QString::number(up_mm(hyoid) / size)));
    const auto leaning = [&](const UpperAirway& of) {
        const Vec3 leaf = of.p_A_epiglottisTip - of.p_A_epiglottisBase;
        return std::atan2(-leaf.dot(a.forward_A()), leaf.dot(a.up_A));
    };
    QVERIFY2(inDegrees(radians(leaning(moved) - leaning(a))) > 15.0,
             qPrintable(QString::number(inDegrees(radians(leaning(moved) - leaning(a))))));
    const Vec3 palate = moved.p_A_uvula - a.p_A_uvula;
    QVERIFY(up_mm(palate) > 2.0 * a.size() && forward_mm(palate) < -1.0 * a.size());
    Person risen{name}; // so that the width is that where the cords are then
    risen.airway = moved;
    QVERIFY(widthOfGlottis(risen, field, 0.45) < 0.5 * kMillimetre);
    QVERIFY(mostOf(person, field, "Trachea") > 4.0 * kMillimetre * size);
    QVERIFY(mostOf(person, field, "Left upper central secondary incisor tooth") == 0.0);
}

// Two at their worst are drawn as they are, and of four each as one of half the severity; what is
// not in the throat is as before.
void TestAirwayChanges::sharesTheRoomOfTheThroat()
{
    const Person person{QStringLiteral("adult")};
    using enum AirwayEventKind;
    const auto swellings = [&](const AirwayEvents& events) {
        return airwayChanges(person.airway, events).frame().swellings;
    };
    const auto both = swellings({{Epiglottitis, 1.0}, {FloppyEpiglottis, 1.0}});
    QCOMPARE(both[0].outward, swellings({{Epiglottitis, 1.0}})[0].outward);
    QVERIFY(both[1].shift == swellings({{FloppyEpiglottis, 1.0}})[0].shift);
    const AirwayEvents four{{TongueOedema, 1.0},
                            {PharyngealSwelling, 1.0},
                            {Epiglottitis, 1.0},
                            {Laryngospasm, 1.0},
                            {FloppyEpiglottis, 1.0}};
    const AirwayEvents halves{{TongueOedema, 0.5},
                              {PharyngealSwelling, 0.5},
                              {Epiglottitis, 0.5},
                              {Laryngospasm, 1.0},
                              {FloppyEpiglottis, 0.5}};
    for (const char* part : {"Tongue", "Uvula", "Epiglottis", "Left vocal fold"})
        QVERIFY2(person.verticesOf(part, airwayChanges(person.airway, four))
                     == person.verticesOf(part, airwayChanges(person.airway, halves)),
                 part);
}

// But trismus, which is of the jaw (tst_mouth_opening.cpp), a stiff neck (tst_neck_motion.cpp),
// what lies in the throat (tst_airway_contents.cpp), and loose teeth, of
// which one moves by less.
void TestAirwayChanges::movesMoreWithTheSeverity_data()
{
    QTest::addColumn<AirwayEventKind>("kind");
    for (int kind = 0; kind < kAirwayEventKinds; ++kind) {
        const auto each = static_cast<AirwayEventKind>(kind);
        if (each != AirwayEventKind::Trismus && each != AirwayEventKind::StiffNeck
            && each != AirwayEventKind::FragileTeeth
            && std::ranges::find(kThroatContents, each) == kThroatContents.end())
            QTest::newRow(eventName(each)) << each;
    }
}

void TestAirwayChanges::movesMoreWithTheSeverity()
{
    QFETCH(AirwayEventKind, kind);
    const Person person{QStringLiteral("adult")};
    const auto farthest = [&](double severity) {
        const AirwayField field = person.field(kind, severity);
        double most = 0.0;
        for (const AnatomyPart& part : person.anatomy.parts)
            if (const auto tissue = airwayTissueOf(regionOf(part)))
                for (const Vec3f& p : part.levels.front().positions)
                    most = std::max(
                        most,
                        airwayPull<double>(field.frame(), *tissue, p.cast<double>()).d.norm());
        return most;
    };
    double last = 0.0;
    for (const double severity : {0.1, 0.4, 0.7, 1.0}) {
        const double most = farthest(severity);
        QVERIFY(most > last + 0.2 * kMillimetre);
        last = most;
    }
    QVERIFY2(last < 20.0 * kMillimetre, qPrintable(QString::number(1e3 * last)));
}

void TestAirwayChanges::foldsNowhereWithAllEventsAtOnce()
{
    QFETCH(QString, name);
    const Person person{name};
    AirwayEvents all;
    for (int kind = 0; kind < kAirwayEventKinds; ++kind)
        all.push_back({static_cast<AirwayEventKind>(kind), 1.0});
    const AirwayField field = airwayChanges(person.airway, all, 0.0);
    double least = 1.0;
    for (const AnatomyPart& part : person.anatomy.parts)
        if (const auto tissue = airwayTissueOf(regionOf(part)))
            for (const Vec3f& p : part.levels.front().positions) {
                const Mat3 gradient =
                    airwayPull<double>(field.frame(), *tissue, p.cast<double>()).gradient;
                least = std::min(least, (Mat3::Identity() + gradient).determinant());
            }
    qInfo("least determinant %.4f", least);
    QVERIFY(least > 0.0);
}

void TestAirwayChanges::saysWhatASetCannotShow()
{
    Person person{QStringLiteral("adult")};
    for (int kind = 0; kind < kAirwayEventKinds; ++kind)
        QVERIFY(canShow(person.airway, static_cast<AirwayEventKind>(kind)));
    person.airway.p_A_tongue.reset();
    QVERIFY(!canShow(person.airway, AirwayEventKind::TongueOedema));
    QVERIFY(!person.field(AirwayEventKind::TongueOedema, 1.0).isThere());
    person.airway.p_A_epiglottisTip = person.airway.p_A_epiglottisBase;
    QVERIFY(!canShow(person.airway, AirwayEventKind::Epiglottitis));
    QVERIFY(!person.field(AirwayEventKind::Epiglottitis, 1.0).isThere());
    QVERIFY(!canShow(person.airway, AirwayEventKind::FloppyEpiglottis));
    QVERIFY(canShow(person.airway, AirwayEventKind::AngioOedema)); // what there is of it
    QVERIFY(canShow(person.airway, AirwayEventKind::Laryngospasm));
    person.airway.p_A_notch = person.airway.p_A_commissure;
    QVERIFY(!airwayChanges(person.airway, {{AirwayEventKind::Laryngospasm, 1.0}}, 0.0).isThere());
    for (const auto kind :
         {AirwayEventKind::AnteriorLarynx, AirwayEventKind::AngioOedema,
          AirwayEventKind::LaryngealWeb, AirwayEventKind::ExternalPressure, AirwayEventKind::Burn,
          AirwayEventKind::Blood, AirwayEventKind::ForeignBody})
        QVERIFY(!canShow(person.airway, kind));
    for (const auto kind : {AirwayEventKind::TrachealStenosis, AirwayEventKind::TrachealDeviation,
                            AirwayEventKind::Goitre, AirwayEventKind::ProminentIncisors,
                            AirwayEventKind::FragileTeeth})
        QVERIFY(canShow(person.airway, kind));
    person.airway.windpipe.reset();
    person.airway.hasIncisors = false;
    for (const auto kind : {AirwayEventKind::TrachealStenosis, AirwayEventKind::TrachealDeviation,
                            AirwayEventKind::Goitre, AirwayEventKind::ProminentIncisors,
                            AirwayEventKind::FragileTeeth}) {
        QVERIFY(!canShow(person.airway, kind));
        QVERIFY(!person.field(kind, 1.0).isThere());
    }
}

CARINA_TEST(TestAirwayChanges)

} // namespace carina::airway_changes_test

#include "tst_airway_changes.moc"
