#include "engine/io/anatomy_set/anatomy_set.h"
#include "engine/io/mesh/surface_reader.h"
#include "tests/engine/io/mesh/texture_files.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <algorithm>
#include <memory>
#include <random>

namespace carina::surface_texture_test
{
namespace
{

constexpr int kSide = 256; ///< of a picture, pixels
constexpr double kRadius = 150.0;
constexpr double kHeight = 900.0;
constexpr test::Tetrahedron kSolid{100.0F, -5.0F, -5.0F, 700.0F};

/// Red grows to the right, green upwards.
test::Pixel slope(double u, double v)
{
    return {static_cast<unsigned char>(255.0 * u), static_cast<unsigned char>(255.0 * v), 128};
}

/// Red in the upper left, blue in the lower right, green elsewhere.
test::Pixel quarters(double u, double v)
{
    if (u < 0.5 && v > 0.5)
        return {255, 0, 0};
    return u > 0.5 && v < 0.5 ? test::Pixel{0, 0, 255} : test::Pixel{0, 255, 0};
}

bool near(const Rgb& color, const Rgb& meant, int tolerance)
{
    return std::equal(color.begin(), color.end(), meant.begin(),
                      [tolerance](int a, int b) { return std::abs(a - b) <= tolerance; });
}

const AnatomyPart& skinOf(const Anatomy& anatomy)
{
    return *std::find_if(anatomy.parts.begin(), anatomy.parts.end(),
                         [](const AnatomyPart& part) { return part.role == PartRole::Skin; });
}

} // namespace

class TestSurfaceTexture final : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_temporary;
    std::filesystem::path m_set;

    void write(const std::string& name, const std::string& bytes) const
    {
        test::writeFile(m_set / name, bytes);
    }
    void writeSkin(const std::string& picture) const
    {
        write("skin.mtl", "newmtl face\nKd 0.1 0.2 0.3\nmap_Kd " + picture + '\n');
        write("skin.obj",
              test::texturedBallObj(kRadius, kHeight, "mtllib skin.mtl\no Skin\nusemtl face\n"));
    }
    Result<LoadedSet> load() const
    {
        return loadAnatomySet(m_set, m_temporary->path().toStdString() + "/cache", {},
                              CacheUse::Allowed);
    }
    Result<MeshFile> read(const std::string& name, const std::string& bytes) const
    {
        write(name, bytes);
        return SurfaceReader{}.read(m_set / name);
    }

private Q_SLOTS:
    void init()
    {
        m_temporary = std::make_unique<QTemporaryDir>();
        m_set = m_temporary->path().toStdString() + "/Somebody";
        write("Trachea.obj", test::objOf(kSolid));
    }

    void givesEachVertexOfEachLevelTheColourOfItsPlace_data()
    {
        QTest::addColumn<QString>("picture");
        QTest::newRow("PNG") << QStringLiteral("face.png");
        QTest::newRow("JPEG") << QStringLiteral("maps/face.jpg");
        QTest::newRow("named as on another machine") << QStringLiteral("C:\\work\\face.png");
    }

    void givesEachVertexOfEachLevelTheColourOfItsPlace()
    {
        QFETCH(QString, picture);
        const auto pixels = test::pixelsOf(kSide, slope);
        write("face.png", test::pngOf(kSide, pixels));
        write("maps/face.jpg", test::jpegOf(kSide, pixels));
        writeSkin(picture.toStdString());
        (void)load();
        const auto loaded = load(); // from the cache
        QVERIFY2(loaded.has_value(), loaded ? "" : loaded.error().detail.c_str());
        QVERIFY(loaded->set.faults.empty());
        const AnatomyPart& skin = skinOf(loaded->set.anatomy);
        QVERIFY(skin.levels.size() > 2);
        QCOMPARE(skin.colors.size(), skin.levels.size());
        const Vec3 centre = boundsOf(skin.levels[0]).centre();
        for (std::size_t level = 0; level < skin.levels.size(); ++level) {
            const std::vector<Vec3f>& positions = skin.levels[level].positions;
            QCOMPARE(skin.colors[level].size(), positions.size());
            for (std::size_t i = 0; i < positions.size(); ++i) {
                const Vec3 unit = (positions[i].cast<double>() - centre) / (1e-3 * kRadius);
                const auto [u, v] = test::placeInPicture(unit.x(), unit.z());
                QVERIFY(near(skin.colors[level][i], slope(u, v), 4));
            }
        }
    }

    void readsTheTexturesOfAGltf()
    {
        write("quarters.png", test::pngOf(kSide, test::pixelsOf(kSide, quarters)));
        const auto file =
            read("scene.gltf", test::texturedGltf(kSolid, (m_set / "quarters.png").string()));
        QVERIFY2(file.has_value(), file ? "" : file.error().detail.c_str());
        QVERIFY(file->textureFaults.empty());
        const NamedSurface& surface = file->surfaces[0];
        QCOMPARE(surface.colors.size(), std::size_t{4});
        const Vec3f last{kSolid.x, kSolid.y, kSolid.z + kSolid.size};
        for (std::size_t i = 0; i < 4; ++i) {
            // Half of linear red is 188 in sRGB (IEC 61966-2-1).
            const bool isLast = surface.mesh.positions[i] == last;
            QVERIFY(near(surface.colors[i], isLast ? Rgb{0, 0, 255} : Rgb{188, 0, 0}, 1));
        }
    }

    void takesTheColoursOfVertices()
    {
        const auto file =
            read("Heart.ply",
                 "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                 "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                 "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
                 "0 0 0 200 10 20\n1 0 0 0 100 0\n0 1 0 0 0 255\n0 0 1 255 255 255\n"
                 "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
        QVERIFY2(file.has_value(), file ? "" : file.error().detail.c_str());
        const NamedSurface& surface = file->surfaces[0];
        QCOMPARE(surface.colors.size(), std::size_t{4});
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3f& p = surface.mesh.positions[i];
            const Rgb meant = p.x() > 0   ? Rgb{0, 100, 0}
                              : p.y() > 0 ? Rgb{0, 0, 255}
                              : p.z() > 0 ? Rgb{255, 255, 255}
                                          : Rgb{200, 10, 20};
            QVERIFY(near(surface.colors[i], meant, 0));
        }
    }

    void averagesWhatIsFinerThanTheSurface()
    {
        const auto checks = [](double u, double v) {
            const int sum = int(u * kSide) + int(v * kSide);
            return sum % 2 == 0 ? test::Pixel{0, 0, 0} : test::Pixel{255, 255, 255};
        };
        write("face.png", test::pngOf(kSide, test::pixelsOf(kSide, checks)));
        writeSkin("face.png");
        const auto file = SurfaceReader{}.read(m_set / "skin.obj");
        QVERIFY2(file.has_value(), file ? "" : file.error().detail.c_str());
        for (const Rgb& color : file->surfaces[0].colors)
            QVERIFY(near(color, {128, 128, 128}, 16));
    }

    /// One colour says no more than the role does.
    void leavesASurfaceOfOneColourTheColourOfItsRole()
    {
        write("face.png", test::pngOf(kSide, test::pixelsOf(kSide, [](double, double) {
                                          return test::Pixel{90, 90, 90};
                                      })));
        writeSkin("face.png");
        const auto loaded = load();
        QVERIFY2(loaded.has_value(), loaded ? "" : loaded.error().detail.c_str());
        QVERIFY(skinOf(loaded->set.anatomy).colors.empty());
    }

    void namesATextureThatCannotBeUsedAndKeepsTheSurface_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        const std::string png = test::pngOf(kSide, test::pixelsOf(kSide, slope));
        const std::string jpeg = test::jpegOf(kSide, test::pixelsOf(kSide, slope));
        const auto row = [](const char* name, const std::string& bytes) {
            QTest::newRow(name) << QByteArray::fromStdString(bytes);
        };
        row("missing", {});
        row("no picture", "GIF89a");
        row("PNG cut", png.substr(0, png.size() / 2));
        row("JPEG cut", jpeg.substr(0, jpeg.size() / 2));
        std::string large = png;
        large.replace(16, 8, std::string{"\x7f\xff\xff\xff\x7f\xff\xff\xff", 8});
        row("PNG of a size that cannot be", large);
    }

    void namesATextureThatCannotBeUsedAndKeepsTheSurface()
    {
        QFETCH(QByteArray, bytes);
        if (!bytes.isEmpty())
            write("face.png", bytes.toStdString());
        writeSkin("face.png");
        const auto loaded = load();
        QVERIFY2(loaded.has_value(), loaded ? "" : loaded.error().detail.c_str());
        QVERIFY(skinOf(loaded->set.anatomy).colors.empty());
        QCOMPARE(loaded->set.faults.size(), std::size_t{1});
        QCOMPARE(loaded->set.faults[0].file, std::string{"skin.obj"});
        QVERIFY(loaded->set.faults[0].error.detail.find("face.png") != std::string::npos);
    }

    void opensNothingOutsideTheFolderOfAFile()
    {
        test::writeFile(m_set.parent_path() / "face.png",
                        test::pngOf(kSide, test::pixelsOf(kSide, slope)));
        writeSkin("../face.png");
        const auto outside = SurfaceReader{}.read(m_set / "skin.obj");
        QVERIFY(outside.has_value() && outside->surfaces[0].colors.empty());
        std::filesystem::rename(m_set / "skin.mtl", m_set.parent_path() / "skin.mtl");
        write("face.png", test::pngOf(kSide, test::pixelsOf(kSide, slope)));
        const auto materials = read("skin.obj", test::texturedBallObj(kRadius, kHeight,
                                                                      "mtllib ../skin.mtl\n"
                                                                      "o Skin\nusemtl face\n"));
        QVERIFY2(materials.has_value(), materials ? "" : materials.error().detail.c_str());
        QVERIFY(materials->surfaces[0].colors.empty());
    }

    void isAnotherSetWithAnotherTexture()
    {
        write("face.png", test::pngOf(kSide, test::pixelsOf(kSide, slope)));
        writeSkin("face.png");
        const auto before = load();
        write("face.png", test::pngOf(kSide, test::pixelsOf(kSide, quarters)));
        const auto after = load();
        QVERIFY(before.has_value() && after.has_value());
        QVERIFY(before->set.anatomy.contentHash != after->set.anatomy.contentHash);
        QVERIFY(skinOf(before->set.anatomy).colors != skinOf(after->set.anatomy).colors);
    }

    void survivesDamagedPictures_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        const auto pixels = test::pixelsOf(32, slope);
        QTest::newRow("PNG") << QByteArray::fromStdString(test::pngOf(32, pixels));
        QTest::newRow("JPEG") << QByteArray::fromStdString(test::jpegOf(32, pixels));
    }

    /// The surface is there whatever has become of its picture.
    void survivesDamagedPictures()
    {
        QFETCH(QByteArray, bytes);
        writeSkin("face.png");
        SurfaceReader reader;
        std::mt19937 random{17};
        for (int round = 0; round < 150; ++round) {
            std::string damaged = bytes.toStdString();
            for (int i = 0; i < 1 + round % 4; ++i)
                damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
            write("face.png", damaged);
            const auto file = reader.read(m_set / "skin.obj");
            QVERIFY2(file.has_value(), file ? "" : file.error().detail.c_str());
            const NamedSurface& skin = file->surfaces[0];
            QVERIFY(skin.colors.empty() || skin.colors.size() == skin.mesh.positions.size());
        }
    }
};

CARINA_TEST(TestSurfaceTexture)

} // namespace carina::surface_texture_test

#include "tst_surface_texture.moc"
