#include "engine/geometry/mesh/mesh_winding.h"
#include "engine/io/anatomy_set/anatomy_set.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QElapsedTimer>
#include <QTemporaryDir>

#include <algorithm>
#include <map>

namespace carina::anatomy_set_real_test
{
namespace
{

constexpr double kVolumeTolerance = 0.01; // share

/// What the lobes enclose, ml, by the columns of tst_real_lobes. The data's own note gives 1297 ml
/// for the left lung: the sum of signed tetrahedra about the origin of the file with the holes at
/// the hilum left open, which are 23 ml there.
const std::map<Side, double> kLungMl{{Side::Right, 1564.4}, {Side::Left, 1320.5}};

long countOf(const Anatomy& anatomy, PartRole role)
{
    return std::count_if(anatomy.parts.begin(), anatomy.parts.end(),
                         [role](const AnatomyPart& part) { return part.role == role; });
}

} // namespace

class TestAnatomySetReal final : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_cache;
    std::optional<LoadedSet> m_loaded;

private Q_SLOTS:
    void initTestCase()
    {
        const auto folder = test::testData("anatomy");
        if (!folder)
            return;
        QElapsedTimer timer;
        timer.start();
        auto loaded = loadAnatomySet(*folder, m_cache.path().toStdString());
        qInfo() << "imported in" << timer.restart() << "ms";
        QVERIFY2(loaded.has_value(), loaded ? "" : loaded.error().detail.c_str());
        m_loaded = std::move(*loaded);
        const auto again = loadAnatomySet(*folder, m_cache.path().toStdString());
        qInfo() << "loaded from the cache in" << timer.elapsed() << "ms";
        QVERIFY(again->fromCache);
        QCOMPARE(again->set.anatomy.parts.size(), m_loaded->set.anatomy.parts.size());
    }

    void init()
    {
        if (!test::testData("anatomy"))
            QSKIP("the real anatomy is not here");
    }

    void readsEveryFile()
    {
        const ImportedSet& set = m_loaded->set;
        QVERIFY(set.faults.empty());
        // 358 and 8 files; two given twice, five lobes again in the files of the two whole lungs.
        QCOMPARE(set.anatomy.parts.size(), std::size_t{358 - 2 + 5 + 1});
        QCOMPARE(set.leftOut.size(), std::size_t{2 + 5});
        QCOMPARE(set.frame.metresPerUnit, 1e-3);
        QVERIFY(set.frame.R_AF == Mat3::Identity());
        QVERIFY(set.anatomy.attributions[0].find("BodyParts3D") != std::string::npos);
        QVERIFY(set.anatomy.attributions[1].find("Z-Anatomy") != std::string::npos);
    }

    void dropsWhatIsThereTwice()
    {
        const auto& parts = m_loaded->set.anatomy.parts;
        for (const char* name : {"Cricoid cartilage", "Hyoid bone"})
            QCOMPARE(std::count_if(parts.begin(), parts.end(),
                                   [&](const AnatomyPart& part) { return part.name == name; }),
                     1L);
    }

    void usesLobesAndClosesThem()
    {
        const Anatomy& anatomy = m_loaded->set.anatomy;
        QCOMPARE(countOf(anatomy, PartRole::RightLung), 0L);
        QCOMPARE(countOf(anatomy, PartRole::LeftLung), 0L);
        std::map<Side, double> ml;
        for (const AnatomyPart& part : anatomy.parts) {
            if (const auto side = lungSide(part.role)) {
                for (const TriangleMesh& level : part.levels)
                    QVERIFY(isClosed(level));
                ml[*side] += 1e6 * signedVolume(part.levels[0]);
            }
        }
        qInfo() << "right lung" << ml[Side::Right] << "ml, left lung" << ml[Side::Left] << "ml";
        for (const auto& [side, expected] : kLungMl)
            QVERIFY(std::abs(ml[side] - expected) < kVolumeTolerance * expected);
    }

    void findsEverySurfaceOfBodyParts3dClosed() // as its SOURCE.txt says
    {
        for (const AnatomyPart& part : m_loaded->set.anatomy.parts)
            if (part.role != PartRole::Diaphragm)
                QVERIFY2(isClosed(part.levels[0]), part.name.c_str());
    }

    void givesEveryPartNormalsAndFewerTriangles()
    {
        for (const AnatomyPart& part : m_loaded->set.anatomy.parts) {
            for (std::size_t i = 0; i < part.levels.size(); ++i) {
                QCOMPARE(part.levels[i].normals.size(), part.levels[i].positions.size());
                QVERIFY(i == 0
                        || part.levels[i].triangles.size() < part.levels[i - 1].triangles.size());
            }
        }
    }

    void putsTheOriginAtTheCarina()
    {
        // Trachea FJ2541 ends at z = 1285 mm in its file, its bronchi part a little above.
        const Anatomy& anatomy = m_loaded->set.anatomy;
        QVERIFY(anatomy.landmarks.p_A_carina.norm() < 1e-9);
        QVERIFY(anatomy.landmarks.p_A_incisors.z() > anatomy.landmarks.p_A_glottis.z());
        QVERIFY(anatomy.landmarks.p_A_glottis.z() > 0.08);
        // The path moved with the rest: it ends at the carina and passes by incisors and glottis.
        constexpr double kOnPath = 2e-3; // metres: half the distance of its points, and smoothing
        const auto& path = anatomy.landmarks.path_A;
        QVERIFY(path.back().norm() < kOnPath);
        for (const Vec3& p_A : {anatomy.landmarks.p_A_incisors, anatomy.landmarks.p_A_glottis})
            QVERIFY(std::ranges::any_of(
                path, [&](const Vec3& point) { return (point - p_A).norm() < kOnPath; }));
        for (const AnatomyPart& part : anatomy.parts) {
            const Box box = boundsOf(part.levels[0]);
            if (part.role == PartRole::Trachea)
                QVERIFY(std::abs(box.min.z()) < 0.02 && std::abs(box.centre().x()) < 0.02);
            if (lungSide(part.role) == Side::Right)
                QVERIFY(box.centre().x() < -0.03);
            if (lungSide(part.role) == Side::Left)
                QVERIFY(box.centre().x() > 0.03);
        }
    }
};

CARINA_TEST(TestAnatomySetReal)

} // namespace carina::anatomy_set_real_test

#include "tst_anatomy_set_real.moc"
