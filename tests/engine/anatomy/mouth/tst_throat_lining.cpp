#include "engine/anatomy/larynx/larynx_frame.h"
#include "engine/anatomy/organ_group.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/geometry/mesh/surface_query.h"
#include "tests/engine/anatomy/shapes/section.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <map>

namespace carina::throat_lining_test
{
namespace
{

struct Person {
    PatientDimensions dimensions;
    Anatomy anatomy;
};

/// The patient that these words say.
const Person& personCalled(const QString& words)
{
    static std::map<QString, Person> made;
    if (const auto found = made.find(words); found != made.end())
        return found->second;
    const PatientParameters who = patientFromWords(words.toStdString()).value();
    return made.emplace(words, Person{dimensionsFor(who).value(), patientFor(who).value()})
        .first->second;
}

const TriangleMesh& named(const Person& person, const std::string& name)
{
    return std::ranges::find(person.anatomy.parts, name, &AnatomyPart::name)->levels[0];
}

/// Whether a part is what one sees in a throat, or what lies beneath that.
bool isSeen(const AnatomyPart& part)
{
    const bool isMuscle = part.name.find("constrictor") != std::string::npos;
    return part.role == PartRole::Tongue || part.role == PartRole::Epiglottis
           || part.role == PartRole::Mucosa || part.role == PartRole::LaryngealMucosa
           || part.role == PartRole::VocalFold || (part.role == PartRole::Pharynx && !isMuscle);
}

/// The first part of the airway that a ray meets.
const AnatomyPart* firstHit(const Anatomy& anatomy, const Vec3& p_A, const Vec3& direction_A)
{
    const AnatomyPart* first = nullptr;
    double nearest = 0.0;
    for (const AnatomyPart& part : anatomy.parts) {
        if (groupOf(part.role) != OrganGroup::Airway)
            continue;
        const auto hit = rayHit(part.levels[0], p_A, direction_A);
        if (hit && (first == nullptr || *hit < nearest)) {
            first = &part;
            nearest = *hit;
        }
    }
    return first;
}

/// The level section of a mesh at a share of its height.
Box sectionAt(const TriangleMesh& mesh, double share)
{
    const Box box = boundsOf(mesh);
    const Vec3 at = box.min + share * box.size().z() * Vec3::UnitZ();
    Box section;
    for (const Vec3& p : test::sectionOf(mesh, {at, Vec3::UnitZ()}).points)
        section.include(p);
    return section;
}

} // namespace

/// The lining of mouth and throat, and what hangs in it.
class TestThroatLining : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isWholeBesideTheEpiglottis_data() { people(); }
    void isWholeBesideTheEpiglottis();
    void leavesTheUvulaRound_data() { people(); }
    void leavesTheUvulaRound();
    void letsTheUvulaTaper_data() { people(); }
    void letsTheUvulaTaper();

private:
    static void people()
    {
        QTest::addColumn<QString>("words");
        for (const char* words :
             {"adult", "45 years, 165 cm, woman", "child", "6 years, 116 cm, boy",
              "3 years, 96 cm, boy", "1 year, 75 cm, girl", "newborn, 50 cm, girl"})
            QTest::newRow(words) << QString::fromLatin1(words);
    }
};

/// Mouth, pharynx and larynx have one continuous lining (Gray 1918): who looks down beside the
/// epiglottis sees mucosa, and no cartilage or muscle.
void TestThroatLining::isWholeBesideTheEpiglottis()
{
    QFETCH(QString, words);
    const Person& person = personCalled(words);
    const LarynxFrame larynx{person.dimensions};
    const Vec3 down = larynx.inAnatomy(Vec3::Zero()) - larynx.inAnatomy(Vec3::UnitZ());
    for (double x = 8.5; x <= 14.0; x += 0.5)
        for (double y = -13.0; y <= 0.0; y += 1.0)
            for (const double side : {1.0, -1.0}) {
                const Vec3 from = larynx.inAnatomy(Vec3{side * x, y, 42.0});
                const AnatomyPart* seen = firstHit(person.anatomy, from, down.normalized());
                const std::string where = (seen != nullptr ? seen->name : "nothing") + " at "
                                          + std::to_string(side * x) + ", " + std::to_string(y);
                QVERIFY2(seen != nullptr && isSeen(*seen), where.c_str());
            }
}

/// A conical process (Gray 1918), also in an infant, whose throat is drawn out.
void TestThroatLining::leavesTheUvulaRound()
{
    QFETCH(QString, words);
    const Box section = sectionAt(named(personCalled(words), "Uvula"), 0.25);
    const double depthToWidth = section.size().y() / section.size().x();
    QVERIFY2(depthToWidth > 0.7 && depthToWidth < 1.4, qPrintable(QString::number(depthToWidth)));
}

/// It is a cone, with its point below.
void TestThroatLining::letsTheUvulaTaper()
{
    QFETCH(QString, words);
    const TriangleMesh& uvula = named(personCalled(words), "Uvula");
    const double widths = sectionAt(uvula, 0.2).size().x() / sectionAt(uvula, 0.6).size().x();
    QVERIFY2(widths > 0.4 && widths < 0.8, qPrintable(QString::number(widths)));
}

CARINA_TEST(TestThroatLining)

} // namespace carina::throat_lining_test

#include "tst_throat_lining.moc"
