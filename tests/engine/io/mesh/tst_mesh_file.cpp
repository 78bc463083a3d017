#include "engine/geometry/mesh/mesh_winding.h"
#include "engine/io/mesh/surface_reader.h"
#include "tests/engine/io/mesh/surface_files.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <array>
#include <random>

namespace carina::mesh_file_test
{
namespace
{

constexpr double kVolumeTolerance = 1e-6; // of a solid of 1/6, in single precision
constexpr test::Tetrahedron kSolid{};

/// Every format, in a file named after it.
const std::array kFormats{
    std::pair{"plain.obj", test::objOf(kSolid)},
    std::pair{"ascii.ply", test::asciiPlyOf(kSolid)},
    std::pair{"little.ply", test::binaryPlyOf(kSolid, false)},
    std::pair{"big.ply", test::binaryPlyOf(kSolid, true)},
    std::pair{"ascii.stl", test::asciiStlOf(kSolid, "Trachea")},
    std::pair{"binary.stl", test::binaryStlOf(kSolid)},
    std::pair{"scene.gltf", test::gltfJson("scene.bin")},
    std::pair{"scene.glb", test::glbOf(kSolid)},
};

} // namespace

class TestMeshFile final : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_temporary;
    std::filesystem::path m_folder;
    SurfaceReader m_reader;

    Result<MeshFile> read(const std::string& name, const std::string& bytes)
    {
        test::writeFile(m_folder / name, bytes);
        return m_reader.read(m_folder / name);
    }

private Q_SLOTS:
    void init()
    {
        m_folder = m_temporary.path().toStdString();
        test::writeFile(m_folder / "scene.bin", test::gltfBuffer(kSolid));
    }

    void readsEveryFormat_data()
    {
        QTest::addColumn<int>("format");
        for (std::size_t i = 0; i < kFormats.size(); ++i)
            QTest::newRow(kFormats[i].first) << static_cast<int>(i);
    }

    void readsEveryFormat()
    {
        QFETCH(int, format);
        const auto& [name, bytes] = kFormats[static_cast<std::size_t>(format)];
        const Result<MeshFile> file = read(name, bytes);
        QVERIFY2(file.has_value(), file ? "" : file.error().detail.c_str());
        for (const NamedSurface& surface : file->surfaces) {
            QCOMPARE(surface.mesh.positions.size(), std::size_t{4});
            QCOMPARE(surface.mesh.triangles.size(), std::size_t{4});
            QVERIFY(isClosed(surface.mesh));
            QVERIFY(std::abs(signedVolume(surface.mesh) - 1.0 / 6.0) < kVolumeTolerance);
        }
    }

    void refusesEveryTruncation_data() { readsEveryFormat_data(); }

    void refusesEveryTruncation()
    {
        QFETCH(int, format);
        const auto& [name, bytes] = kFormats[static_cast<std::size_t>(format)];
        for (std::size_t length = 0; length + 1 < bytes.size(); ++length) {
            const Result<MeshFile> file = read(name, bytes.substr(0, length));
            if (file) {
                // The last words of an ASCII solid only repeat its name, and an OBJ has no mark at
                // its end: between two faces that leave no vertex out, no cut can be seen.
                const bool whole = file->surfaces[0].mesh.triangles.size() == 4;
                const bool unseen =
                    bytes.starts_with("v ") && (bytes[length - 1] == '\n' || bytes[length] == '\n');
                QVERIFY2(whole || unseen, std::to_string(length).c_str());
                continue;
            }
            QVERIFY(file.error().detail.starts_with((m_folder / name).string() + ": "));
            QVERIFY(file.error().code == (length == 0 ? Errc::FileEmpty : Errc::FileMalformed));
        }
    }

    void survivesAnyDamage_data() { readsEveryFormat_data(); }

    void survivesAnyDamage()
    {
        QFETCH(int, format);
        const auto& [name, bytes] = kFormats[static_cast<std::size_t>(format)];
        std::mt19937 random{11};
        for (int round = 0; round < 150; ++round) {
            std::string damaged = bytes;
            for (int i = 0; i < 1 + round % 4; ++i)
                damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
            const Result<MeshFile> file = read(name, damaged);
            if (!file)
                continue;
            for (const NamedSurface& surface : file->surfaces) {
                for (const Vec3f& p : surface.mesh.positions)
                    QVERIFY(p.allFinite());
                for (const Triangle& t : surface.mesh.triangles)
                    for (const std::uint32_t v : t)
                        QVERIFY(v < surface.mesh.positions.size());
            }
        }
    }

    void takesNameAndConceptFromComments()
    {
        const std::string comments = "# The license is CC BY-SA.\n# Concept ID : FMA7394\n"
                                     "# English name : Trachea\n#\n";
        const auto obj = read("FJ1.obj", comments + test::objOf(kSolid));
        QVERIFY(obj.has_value());
        QCOMPARE(obj->surfaces[0].name, std::string{"Trachea"});
        QCOMPARE(obj->surfaces[0].conceptId, std::string{"FMA7394"});
        QCOMPARE(obj->attributions, std::vector<std::string>{"The license is CC BY-SA."});

        const auto ply = read("a.ply", test::asciiPlyOf(kSolid, "comment Concept ID : FMA9615\n"));
        QVERIFY(ply.has_value());
        QCOMPARE(ply->surfaces[0].name, std::string{"a"});
        QCOMPARE(ply->surfaces[0].conceptId, std::string{"FMA9615"});
    }

    void namesASurfaceAfterItsFileWhereNothingElseDoes()
    {
        QCOMPARE(read("Mandible.obj", test::objOf(kSolid))->surfaces[0].name,
                 std::string{"Mandible"});
        QCOMPARE(read("FMA7394 x.stl", test::binaryStlOf(kSolid))->surfaces[0].conceptId,
                 std::string{"FMA7394"});
        QCOMPARE(read("a.stl", test::asciiStlOf(kSolid, "Trachea"))->surfaces[0].name,
                 std::string{"Trachea"});
    }

    void givesEachGroupOfAnObjAsASurface()
    {
        const auto file = read("two.obj", "o Trachea\n" + test::objOf(kSolid) + "o Mandible\n"
                                              + test::objOf({2.0F, 9.0F}, 5));
        QVERIFY(file.has_value());
        QCOMPARE(file->surfaces.size(), std::size_t{2});
        QCOMPARE(file->surfaces[0].name, std::string{"Trachea"});
        QCOMPARE(file->surfaces[1].name, std::string{"Mandible"});
        QVERIFY(std::abs(signedVolume(file->surfaces[1].mesh) - 8.0 / 6.0) < kVolumeTolerance);
    }

    void placesTheNodesOfAGltf()
    {
        const auto file = read("scene.glb", test::glbOf(kSolid));
        QVERIFY(file.has_value());
        QCOMPARE(file->surfaces.size(), std::size_t{2});
        QCOMPARE(file->surfaces[0].name, std::string{"Trachea"});
        QCOMPARE(boundsOf(file->surfaces[0].mesh).min.x(), 0.0);
        QCOMPARE(file->surfaces[1].name, std::string{"Left lung"});
        QCOMPARE(boundsOf(file->surfaces[1].mesh).min.x(), 5.0);
        QCOMPARE(file->attributions, std::vector<std::string>{"CC BY 4.0, Somebody"});
    }

    void namesTheFault_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("bytes");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* what, const char* name, const std::string& bytes, Errc code,
                            const char* words) {
            QTest::newRow(what) << QString::fromLatin1(name) << QByteArray::fromStdString(bytes)
                                << static_cast<int>(code) << QString::fromLatin1(words);
        };
        const std::string obj = test::objOf(kSolid);
        row("empty", "a.obj", "", Errc::FileEmpty, "empty");
        row("no surface format", "a.txt", "x", Errc::UnknownFormat, "OBJ");
        row("NaN", "a.obj", "v nan 0 0\n" + obj, Errc::NotFinite, "line 1");
        row("infinity", "a.obj", "v 0 0 -inf\n" + obj, Errc::NotFinite, "line 1");
        row("beyond single precision", "a.obj", "v 0 0 1e39\n" + obj, Errc::NotFinite, "line 1");
        row("no triangles", "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", Errc::FileMalformed,
            "no triangles");
        row("only comments", "a.obj", "# nothing\n", Errc::FileMalformed, "no triangles");
        row("only points in a PLY", "a.ply",
            "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
            "property float z\nend_header\n0 0 0\n",
            Errc::FileMalformed, "");
        row("index beyond the vertices", "a.obj", obj + "f 1 2 5\n", Errc::FileMalformed,
            "vertex 5 of 4");
        row("index zero", "a.obj", obj + "f 0 1 2\n", Errc::FileMalformed, "line 9");
        row("index before the vertices", "a.obj", obj + "f -5 1 2\n", Errc::FileMalformed,
            "line 9");
        row("face of two", "a.obj", obj + "f 1 2\n", Errc::FileMalformed, "line 9");
        row("vertices without a face", "a.obj", "v 9 9 9\n" + obj, Errc::FileMalformed,
            "truncated");
        row("NaN in ASCII PLY", "a.ply",
            test::plyHeader("ascii")
                + "nan 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n"
                  "3 1 2 3\n",
            Errc::NotFinite, "finite");
        row("NaN in PLY", "a.ply", test::binaryPlyOf({std::nanf(""), 0.0F}, false), Errc::NotFinite,
            "finite");
        row("NaN in STL", "a.stl", test::binaryStlOf({std::nanf(""), 0.0F}), Errc::NotFinite,
            "finite");
        row("NaN in GLB", "a.glb", test::glbOf({std::nanf(""), 0.0F}), Errc::NotFinite, "finite");
        row("a PLY that is none", "a.ply", "solid a\n", Errc::FileMalformed, "ply");
        row("a missing buffer", "a.gltf", test::gltfJson("gone.bin"), Errc::FileNotFound,
            "gone.bin");
        row("a buffer outside the folder", "a.gltf", test::gltfJson("../gone.bin"),
            Errc::FileMalformed, "outside");
    }

    void namesTheFault()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(int, code);
        QFETCH(QString, words);
        const Result<MeshFile> file = read(name.toStdString(), bytes.toStdString());
        QVERIFY(!file.has_value());
        const QString detail = QString::fromStdString(file.error().detail);
        QVERIFY2(file.error().code == static_cast<Errc>(code), qPrintable(detail));
        QVERIFY2(
            detail.startsWith(QString::fromStdString((m_folder / name.toStdString()).string())),
            qPrintable(detail));
        QVERIFY2(detail.contains(words), qPrintable(detail));
    }

    void refusesWhatIsNotThereOrNoFile()
    {
        QVERIFY(m_reader.read(m_folder / "none.obj").error().code == Errc::FileNotFound);
        std::filesystem::create_directories(m_folder / "folder.obj");
        QVERIFY(m_reader.read(m_folder / "folder.obj").error().code == Errc::FileUnreadable);
    }

    void endsAReaderThatTakesTooLong()
    {
        test::writeFile(m_folder / "a.obj", test::objOf(kSolid));
        SurfaceReader hurried{std::chrono::milliseconds{0}};
        const Result<MeshFile> file = hurried.read(m_folder / "a.obj");
        QVERIFY(file.error().code == Errc::FileMalformed);
        QVERIFY(file.error().detail.starts_with((m_folder / "a.obj").string()));
    }

    void toleratesOneLooseVertexInAHundred()
    {
        std::string obj;
        for (int i = 0; i < 396; ++i)
            obj += "v 0 0 " + std::to_string(i) + '\n';
        obj += test::objOf(kSolid, 397) + "f";
        for (int i = 0; i < 392; ++i)
            obj += ' ' + std::to_string(i + 1);
        QVERIFY(read("a.obj", obj + '\n').has_value()); // 4 loose of 400
        QVERIFY(!read("a.obj", obj).has_value());       // the last line does not end
        QVERIFY(!read("a.obj", "v 0 0 0\n" + obj + '\n').has_value());
    }
};

CARINA_TEST(TestMeshFile)

} // namespace carina::mesh_file_test

#include "tst_mesh_file.moc"
