#include "engine/io/anatomy_set/set_frame.h"
#include "tests/support/test_class.h"

namespace carina::set_frame_test
{
namespace
{

/// A tetrahedron in a box of the given size, metres, in the axes of A.
RecognisedSurface surface(const char* name, PartRole role, const Vec3& p_A, double size)
{
    TriangleMesh mesh;
    for (const Vec3& corner : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        mesh.positions.push_back((p_A + size * corner).cast<float>());
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return {name, name, {}, role, std::move(mesh)};
}

/// A patient of a few parts, metres, in the axes of A.
std::vector<RecognisedSurface> patient()
{
    return {surface("Trachea", PartRole::Trachea, {-0.01, -0.02, 0.0}, 0.1),
            surface("Right lung", PartRole::RightLung, {-0.2, -0.1, -0.2}, 0.2),
            surface("Left lung", PartRole::LeftLung, {0.02, -0.1, -0.2}, 0.2),
            surface("Mandible", PartRole::Mandible, {-0.05, -0.12, 0.15}, 0.1),
            surface("Axis", PartRole::Spine, {-0.02, 0.05, 0.1}, 0.04)};
}

void place(std::vector<RecognisedSurface>& surfaces, const Mat3& R_FA, double unitsPerMetre)
{
    for (RecognisedSurface& s : surfaces)
        for (Vec3f& p : s.mesh.positions)
            p = (unitsPerMetre * R_FA * p.cast<double>()).cast<float>();
}

Mat3 rows(const Vec3& x, const Vec3& y, const Vec3& z)
{
    Mat3 m;
    m << x.transpose(), y.transpose(), z.transpose();
    return m;
}

} // namespace

class TestSetFrame final : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsUnitAndAxes_data()
    {
        const Vec3 left = Vec3::UnitX();
        const Vec3 posterior = Vec3::UnitY();
        const Vec3 superior = Vec3::UnitZ();
        QTest::addColumn<double>("metresPerUnit");
        QTest::addColumn<QList<double>>("R_FA");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* name, double metresPerUnit, const Mat3& R_FA,
                            const char* words) {
            QTest::newRow(name) << metresPerUnit
                                << QList<double>(R_FA.data(), R_FA.data() + R_FA.size())
                                << QString::fromLatin1(words);
        };
        row("LPS in millimetres", 1e-3, rows(left, posterior, superior), "left posterior superior");
        row("RAS in millimetres", 1e-3, rows(-left, -posterior, superior),
            "right anterior superior");
        row("y up in metres", 1.0, rows(left, superior, -posterior), "left superior anterior");
        row("z down in centimetres", 1e-2, rows(-left, posterior, -superior),
            "right posterior inferior");
        row("x up", 1.0, rows(superior, left, posterior), "superior left posterior");
        row("a mirror image", 1e-3, rows(-left, posterior, superior), "right posterior superior");
    }

    void findsUnitAndAxes()
    {
        QFETCH(double, metresPerUnit);
        QFETCH(QList<double>, R_FA);
        QFETCH(QString, words);
        const Mat3 R = Eigen::Map<const Mat3>(R_FA.data());
        std::vector<RecognisedSurface> surfaces = patient();
        place(surfaces, R, 1.0 / metresPerUnit);
        const auto frame = findSetFrame(surfaces);
        QVERIFY(frame.has_value());
        QCOMPARE(frame->metresPerUnit, metresPerUnit);
        QVERIFY(frame->R_AF == R.transpose());
        QString found;
        for (const std::string& word : axisWords(*frame))
            found += QString::fromStdString(word) + QLatin1Char(' ');
        QCOMPARE(found.trimmed(), words);
    }

    void tellsUnitsBy_data()
    {
        QTest::addColumn<int>("role");
        QTest::addColumn<double>("size");
        QTest::addColumn<double>("metresPerUnit"); // 0: none fits
        const auto row = [](const char* name, PartRole role, double size, double metresPerUnit) {
            QTest::newRow(name) << static_cast<int>(role) << size << metresPerUnit;
        };
        row("a trachea of an infant in mm", PartRole::Trachea, 40.0, 1e-3);
        row("a trachea of an adult in cm", PartRole::Trachea, 11.0, 1e-2);
        row("a trachea of an adult in m", PartRole::Trachea, 0.11, 1.0);
        row("a lung in cm", PartRole::LeftLowerLobe, 25.0, 1e-2);
        row("a lung in mm", PartRole::RightLung, 150.0, 1e-3);
        row("a mandible in mm", PartRole::Mandible, 110.0, 1e-3);
        row("a thorax in mm", PartRole::Rib, 300.0, 1e-3);
        row("a thorax in cm", PartRole::Rib, 30.0, 1e-2);
        row("a whole body in mm", PartRole::Skin, 1700.0, 1e-3);
        row("a whole body in m", PartRole::Skin, 1.7, 1.0);
        row("an ant", PartRole::Rib, 0.003, 0.0);
        row("a ship", PartRole::Rib, 90000.0, 0.0);
        row("a trachea of no size, by the whole", PartRole::Trachea, 0.5, 1.0);
    }

    void tellsUnitsBy()
    {
        QFETCH(int, role);
        QFETCH(double, size);
        QFETCH(double, metresPerUnit);
        const std::vector<RecognisedSurface> surfaces{
            surface("part", static_cast<PartRole>(role), {1.0, 2.0, 3.0}, size)};
        const auto frame = findSetFrame(surfaces);
        QCOMPARE(frame.has_value(), metresPerUnit > 0.0);
        if (frame)
            QCOMPARE(frame->metresPerUnit, metresPerUnit);
        else
            QVERIFY(frame.error().code == Errc::OutOfRange);
    }

    void assumesLpsWhereNothingTells()
    {
        const std::vector<RecognisedSurface> surfaces{
            surface("Rib", PartRole::Rib, Vec3::Zero(), 300.0)};
        QVERIFY(findSetFrame(surfaces)->R_AF == Mat3::Identity());
    }

    void assumesTheAxesAndMetresOfGltfWhereNothingTells_data()
    {
        QTest::addColumn<QString>("ending");
        QTest::newRow("text") << QStringLiteral(".gltf");
        QTest::newRow("binary") << QStringLiteral(".GLB");
    }

    void assumesTheAxesAndMetresOfGltfWhereNothingTells()
    {
        QFETCH(QString, ending);
        std::vector surfaces{surface("Axis", PartRole::Spine, {-0.02, 0.05, 0.1}, 0.04)};
        QVERIFY(!findSetFrame(surfaces)); // 4 cm: no person
        surfaces.front().file = "axis" + ending.toStdString();
        const auto frame = findSetFrame(surfaces);
        QVERIFY(frame);
        QCOMPARE(frame->metresPerUnit, 1.0);
        QVERIFY(axisWords(*frame) == std::vector<std::string>({"left", "superior", "anterior"}));
        QCOMPARE(frame->R_AF.determinant(), 1.0);
    }

    void believesPartsMoreThanTheFormat()
    {
        std::vector surfaces = patient();
        place(surfaces, Mat3::Identity(), 1e3);
        for (RecognisedSurface& s : surfaces)
            s.file += ".glb";
        const auto frame = findSetFrame(surfaces);
        QVERIFY(frame);
        QCOMPARE(frame->metresPerUnit, 1e-3);
        QVERIFY(frame->R_AF.isIdentity());
    }

    void tellsLeftFromBackAndUp()
    {
        std::vector<RecognisedSurface> surfaces = patient();
        std::erase_if(surfaces, [](const auto& s) { return lungSide(s.role).has_value(); });
        const Mat3 R_FA =
            rows(-Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ()); // x front, y left, z up
        place(surfaces, R_FA, 1000.0);
        QVERIFY(findSetFrame(surfaces)->R_AF == R_FA.transpose());
    }

    void refusesAnEmptySet() { QVERIFY(findSetFrame({}).error().code == Errc::OutOfRange); }
};

CARINA_TEST(TestSetFrame)

} // namespace carina::set_frame_test

#include "tst_set_frame.moc"
