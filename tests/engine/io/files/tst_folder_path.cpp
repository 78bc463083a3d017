#include "engine/io/files/folder_path.h"

#include "engine/io/anatomy_set/set_folder.h"
#include "engine/io/mesh/surface_reader.h"
#include "tests/engine/io/mesh/texture_files.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <memory>

namespace carina::folder_path_test
{
namespace
{

namespace fs = std::filesystem;

constexpr int kSide = 64; ///< of a picture, pixels

std::string picture()
{
    return test::pngOf(kSide, test::pixelsOf(kSide, [](double u, double) {
                           return test::Pixel{static_cast<unsigned char>(255.0 * u), 0, 0};
                       }));
}

} // namespace

class TestFolderPath final : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_temporary;
    fs::path m_outside;
    fs::path m_folder;

    Result<MeshFile> skinWith(const std::string& pictureName) const
    {
        test::writeFile(m_folder / "skin.mtl", "newmtl face\nmap_Kd " + pictureName + '\n');
        test::writeFile(m_folder / "skin.obj",
                        test::texturedBallObj(1.0, 0.0, "mtllib skin.mtl\nusemtl face\n"));
        return SurfaceReader{}.read(m_folder / "skin.obj");
    }

private Q_SLOTS:
    void init()
    {
        m_temporary = std::make_unique<QTemporaryDir>();
        m_outside = m_temporary->path().toStdString();
        m_folder = m_outside / "set";
        test::writeFile(m_folder / "inside.txt", "x");
        test::writeFile(m_folder / "below" / "deep.txt", "x");
        test::writeFile(m_outside / "outside.txt", "x");
        test::writeFile(m_outside / "set2" / "sibling.txt", "x");
    }

    void whatLiesWithinIsFound()
    {
        QCOMPARE(pathWithin(m_folder, "inside.txt").value(),
                 fs::canonical(m_folder) / "inside.txt");
        QVERIFY(pathWithin(m_folder, "below/../below/deep.txt"));
        fs::create_symlink("below/deep.txt", m_folder / "link.txt");
        QCOMPARE(pathWithin(m_folder, "link.txt").value(),
                 fs::canonical(m_folder) / "below" / "deep.txt");
        fs::create_symlink(m_folder, m_outside / "alias");
        QVERIFY(pathWithin(m_outside / "alias", "inside.txt"));
    }

    void whatLeadsOutIsRefused()
    {
        fs::create_symlink("../outside.txt", m_folder / "link.txt");
        fs::create_symlink("..", m_folder / "up");
        const std::string absolute = (m_outside / "outside.txt").string();
        for (const std::string& name :
             {std::string{"../outside.txt"}, std::string{"../set2/sibling.txt"},
              std::string{"below/../../outside.txt"}, std::string{"link.txt"},
              std::string{"up/outside.txt"}, absolute}) {
            const auto found = pathWithin(m_folder, name);
            QVERIFY2(!found, name.c_str());
            QCOMPARE(found.error(),
                     (Error{Errc::FileUnreadable,
                            (m_folder / name).string() + ": it leads out of its folder"}));
        }
        QCOMPARE(pathWithin(m_folder, "none").error().code, Errc::FileNotFound);
        QCOMPARE(pathWithin(m_folder / "none", "inside.txt").error().code, Errc::FileNotFound);
    }

    void texturesComeFromTheFolderOnly_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("dots") << QByteArray{"../face.png"};
        QTest::newRow("dots in hexadecimal") << QByteArray{"%2e%2e/face.png"};
        QTest::newRow("all in hexadecimal") << QByteArray{"%2E%2E%2Fface.png"};
        QTest::newRow("down and up") << QByteArray{"below/%2e%2e/../face.png"};
        QTest::newRow("a link to the file") << QByteArray{"link.png"};
        QTest::newRow("a link to the folder") << QByteArray{"up/face.png"};
        QTest::newRow("a link in hexadecimal") << QByteArray{"%75p/face.png"};
    }

    void texturesComeFromTheFolderOnly()
    {
        QFETCH(QByteArray, name);
        test::writeFile(m_outside / "face.png", picture());
        fs::create_symlink("../face.png", m_folder / "link.png");
        fs::create_symlink("..", m_folder / "up");
        const auto skin = skinWith(name.toStdString());
        QVERIFY2(skin.has_value(), skin ? "" : skin.error().detail.c_str());
        QVERIFY(skin->surfaces[0].colors.empty());
        QCOMPARE(skin->textureFaults.size(), std::size_t{1});
    }

    void aTextureBehindALinkWithinTheFolderIsUsed()
    {
        test::writeFile(m_folder / "below" / "face.png", picture());
        fs::create_symlink("below/face.png", m_folder / "link.png");
        const auto skin = skinWith("link.png");
        QVERIFY2(skin.has_value(), skin ? "" : skin.error().detail.c_str());
        QVERIFY(!skin->surfaces[0].colors.empty());
    }

    void materialsAndSurfacesBehindALinkOutAreRefused()
    {
        test::writeFile(m_folder / "face.png", picture());
        test::writeFile(m_outside / "skin.mtl", "newmtl face\nmap_Kd face.png\n");
        fs::create_symlink("../skin.mtl", m_folder / "link.mtl");
        test::writeFile(m_folder / "skin.obj",
                        test::texturedBallObj(1.0, 0.0, "mtllib link.mtl\nusemtl face\n"));
        const auto skin = SurfaceReader{}.read(m_folder / "skin.obj");
        QVERIFY(skin.has_value() && skin->surfaces[0].colors.empty());
        QVERIFY(!skin->textureFaults.empty());
        QCOMPARE(skin->textureFaults[0].code, Errc::FileUnreadable);
        test::writeFile(m_outside / "lung.obj", test::objOf({}));
        fs::create_symlink("../lung.obj", m_folder / "lung.obj");
        QCOMPARE(SurfaceReader{}.read(m_folder / "lung.obj").error().code, Errc::FileUnreadable);
    }

    void buffersOfAGltfComeFromTheFolderOnly()
    {
        test::writeFile(m_outside / "scene.bin", test::gltfBuffer({}));
        fs::create_symlink("../scene.bin", m_folder / "link.bin");
        for (const char* name : {"../scene.bin", "%2e%2e/scene.bin", "link.bin"}) {
            test::writeFile(m_folder / "scene.gltf", test::gltfJson(name));
            QVERIFY2(!SurfaceReader{}.read(m_folder / "scene.gltf"), name);
        }
    }

    void notesBehindALinkOutAreNotShown()
    {
        test::writeFile(m_folder / "lung.obj", test::objOf({}));
        test::writeFile(m_outside / "note", "LICENCE of another\n");
        fs::create_symlink("../note", m_folder / "SOURCE.txt");
        const auto folder = listSetFolder(m_folder);
        QVERIFY(folder.has_value() && folder->companions.size() == 1);
        QVERIFY(attributionsBeside(*folder).empty());
        fs::remove(m_folder / "SOURCE.txt");
        fs::copy_file(m_outside / "note", m_folder / "SOURCE.txt");
        QCOMPARE(attributionsBeside(*folder).size(), std::size_t{1});
    }
};

CARINA_TEST(TestFolderPath)

} // namespace carina::folder_path_test

#include "tst_folder_path.moc"
