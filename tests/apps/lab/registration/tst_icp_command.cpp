#include "apps/lab/command/help.h"
#include "apps/lab/commands.h"
#include "engine/geometry/rigid_transform.h"
#include "tests/engine/registration/fit/swabbed_shapes.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

#include <QJsonArray>

namespace carina::lab::icp_command_test
{
namespace
{

constexpr double kTolerance_mm = 1e-3; // of coordinates written with 6 digits
const Vec3 kHalf_mm{100.0, 60.0, 150.0};
const RigidTransform kX_AM_mm{rotationFromVector({0.3, -0.8, 0.5}), {40.0, -110.0, 60.0}};

std::string digits(double number) { return QByteArray::number(number, 'g', 12).toStdString(); }

std::string objOf(const TriangleMesh& mesh)
{
    std::string text;
    for (const Vec3f& p : mesh.positions)
        text += "v " + digits(p.x()) + ' ' + digits(p.y()) + ' ' + digits(p.z()) + '\n';
    for (const Triangle& t : mesh.triangles)
        text += "f " + std::to_string(t[0] + 1) + ' ' + std::to_string(t[1] + 1) + ' '
                + std::to_string(t[2] + 1) + '\n';
    return text;
}

std::string tableOf(const std::vector<Vec3>& p_mm)
{
    std::string text = "id,mx,my,mz\n";
    for (const Vec3& p : p_mm)
        text += "1," + digits(p.x()) + ',' + digits(p.y()) + ',' + digits(p.z()) + '\n';
    return text;
}

std::string startOf(const RigidTransform& X_mm)
{
    std::string rows;
    const Mat4 matrix = X_mm.matrix();
    for (int row = 0; row < 4; ++row) {
        rows += row == 0 ? "[" : ", [";
        for (int column = 0; column < 4; ++column) {
            rows += column == 0 ? "" : ", ";
            rows += digits(matrix(row, column));
        }
        rows += ']';
    }
    return R"({"schema": "carina.fit/1", "X_AM_mm": [)" + rows + "]}";
}

/// Points of a box and five in the air, where the stylus touched them on the manikin.
std::vector<Vec3> swab_mm(int inAir)
{
    std::mt19937 random{3};
    std::vector<Vec3> p_mm;
    for (const Vec3& p_A : test::swabbed(test::box(kHalf_mm), 150, random))
        p_mm.push_back(kX_AM_mm.inverse() * p_A);
    for (int i = 0; i < inAir; ++i)
        p_mm.push_back(kX_AM_mm.inverse() * Vec3{0.0, 90.0 + i, 0.0});
    return p_mm;
}

} // namespace

class TestIcpCommand : public QObject
{
    Q_OBJECT

private:
    test::ScratchFolder m_folder;

    Result<QJsonObject> icp(const QString& surface, const QString& swab, const QString& start) const
    {
        return icpCommand().run({QStringLiteral("--surface"), surface, QStringLiteral("--swab"),
                                 swab, QStringLiteral("--start"), start});
    }
    QString box() const { return m_folder.write("box.obj", objOf(test::box(kHalf_mm))); }
    QString start() const
    {
        return m_folder.write("start.json",
                              startOf(RigidTransform::translation({1.0, 2.0, -2.0}) * kX_AM_mm));
    }

private Q_SLOTS:
    void refinesAStart()
    {
        const auto object = icp(box(), m_folder.write("swab.csv", tableOf(swab_mm(5))), start());
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        const auto number = [&](const char* key) {
            return object->value(QLatin1StringView{key}).toDouble(-1.0);
        };
        QCOMPARE(object->value(QStringLiteral("schema")).toString(),
                 QStringLiteral("carina.icp/1"));
        QCOMPARE(number("points"), 155.0);
        QCOMPARE(number("outliers"), 5.0);
        QVERIFY(number("rms_mm") >= 0.0 && number("rms_mm") < kTolerance_mm);
        QVERIFY(number("start_rms_mm") > 1.0);
        QVERIFY(number("iterations") >= 2.0);
        QVERIFY(std::abs(number("moved_mm") - 3.0) < kTolerance_mm);
        QVERIFY(number("uncertainty_mm") >= 0.0 && number("uncertainty_mm") < kTolerance_mm);
        QCOMPARE(object->value(QStringLiteral("centre_mm")).toArray().size(), 3);
        QVERIFY(object->value(QStringLiteral("loose")).toArray().isEmpty());
        const QJsonArray rows = object->value(QStringLiteral("X_AM_mm")).toArray();
        for (int i = 0; i < 16; ++i)
            QVERIFY(
                std::abs(rows[i / 4].toArray()[i % 4].toDouble() - kX_AM_mm.matrix()(i / 4, i % 4))
                < kTolerance_mm);
    }

    void namesTheMotionsThatAreLoose()
    {
        const TriangleMesh plane{
            .positions = {{-200, -200, 0}, {200, -200, 0}, {200, 200, 0}, {-200, 200, 0}},
            .normals = {},
            .triangles = {{0, 1, 2}, {0, 2, 3}}};
        std::mt19937 random{4};
        std::vector<Vec3> p_mm;
        for (const Vec3& p_A : test::swabbed(plane, 50, random))
            p_mm.push_back(kX_AM_mm.inverse() * p_A);
        const auto object = icp(m_folder.write("plane.obj", objOf(plane)),
                                m_folder.write("plane.csv", tableOf(p_mm)), start());
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        const QJsonArray loose = object->value(QStringLiteral("loose")).toArray();
        QCOMPARE(loose.size(), 3);
        double squares = 0.0;
        for (const char* key : {"turn", "shift"})
            for (const QJsonValue part :
                 loose[0].toObject().value(QLatin1StringView{key}).toArray())
                squares += part.toDouble() * part.toDouble();
        QVERIFY(std::abs(squares - 1.0) < 1e-9);
    }

    void refusesWhatItCannotUse()
    {
        const QString swab = m_folder.write("swab.csv", tableOf(swab_mm(0)));
        const auto refused = [](const Result<QJsonObject>& object, Errc code,
                                const char* sentence) {
            return !object && object.error().code == code
                   && object.error().detail.find(sentence) != std::string::npos;
        };
        QVERIFY(refused(icp(box(), swab, m_folder.write("a.json", "[")), Errc::FileMalformed,
                        "a.json: at byte"));
        QVERIFY(refused(icp(box(), swab, m_folder.write("b.json", "{}")), Errc::FileMalformed,
                        "b.json: X_AM_mm: four rows of four numbers are expected."));
        QVERIFY(refused(icp(box(), m_folder.write("c.csv", "mx,my\n"), start()),
                        Errc::FileMalformed, "has no column \"mz\""));
        QVERIFY(refused(icp(box(), m_folder.write("d.csv", "mx,my,mz\n1,2,3\n"), start()),
                        Errc::TooFewPoints, "d.csv cannot be fitted: 1 points, and 20 are"));
        QVERIFY(refused(icp(m_folder.write("e.obj", "v 1 2"), swab, start()), Errc::FileMalformed,
                        "e.obj"));
        QVERIFY(
            refused(icp(m_folder.filePath("no.obj"), swab, start()), Errc::FileNotFound, "no.obj"));
        QVERIFY(refused(icp(box(), m_folder.write("air.csv", tableOf(swab_mm(60))), start()),
                        Errc::NoSurfaceFit, "points do not lie on the surface."));
    }

    void refusesAnotherCommandLine()
    {
        for (const QStringList& arguments :
             {QStringList{}, QStringList{QStringLiteral("--surface"), box()},
              QStringList{QStringLiteral("box.obj")}}) {
            const auto object = icpCommand().run(arguments);
            QVERIFY(!object);
            QCOMPARE(object.error().code, Errc::WrongOption);
        }
    }

    void helpNamesEveryKeyAndColumn()
    {
        for (const char* name :
             {"--surface", "--swab", "--start", "mx,my,mz", "schema", "X_AM_mm", "start_rms_mm",
              "rms_mm", "points", "outliers", "iterations", "moved_mm", "centre_mm",
              "uncertainty_mm", "loose", "turn", "shift"})
            QVERIFY2(pageOf(icpCommand()).contains(QLatin1StringView{name}), name);
    }
};

CARINA_TEST(TestIcpCommand)

} // namespace carina::lab::icp_command_test

#include "tst_icp_command.moc"
