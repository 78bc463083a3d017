#include "engine/io/files/file_limit.h"

#include "engine/io/anatomy_set/anatomy_cache.h"
#include "engine/io/anatomy_set/carried_sets.h"
#include "engine/io/anatomy_set/set_corrections.h"
#include "engine/io/anatomy_set/set_folder.h"
#include "engine/io/files/mapped_file.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/mesh/surface_reader.h"
#include "engine/io/site/landmark_exchange.h"
#include "engine/io/site/manikin_json.h"
#include "engine/io/site/site_file.h"
#include "tests/engine/io/files/sparse_file.h"
#include "tests/engine/io/mesh/surface_files.h"
#include "tests/engine/io/mesh/texture_files.h"
#include "tests/support/test_class.h"

#include <QCryptographicHash>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <algorithm>
#include <functional>
#include <memory>
#include <sys/resource.h>
#include <sys/stat.h>

namespace carina::file_limit_test
{
namespace
{

namespace fs = std::filesystem;

constexpr long kLittleMemory_KiB = 64L << 10;
constexpr double kShortTime_s = 1.0;
const std::string kHash(64, 'a');

/// Of this process and of those that it waited for.
double processorTime_s()
{
    double sum = 0.0;
    for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        getrusage(who, &usage);
        for (const timeval& time : {usage.ru_utime, usage.ru_stime})
            sum += double(time.tv_sec) + 1e-6 * double(time.tv_usec);
    }
    return sum;
}

/// The most that this process, or one that it waited for, ever had.
long mostMemory_KiB()
{
    long most = 0;
    for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        getrusage(who, &usage);
        most = std::max(most, usage.ru_maxrss);
    }
    return most;
}

template <class Value> Error errorOf(const Result<Value>& result)
{
    return result ? Error{Errc::Cancelled, "it was read"} : result.error();
}

/// A reader of one kind of file.
struct Reader {
    const char* name;
    const char* file;
    std::string head;
    std::function<Error(const fs::path&)> read;
};

const std::vector<Reader>& readers()
{
    static const std::vector<Reader> kReaders{
        {"a text", "a.txt", "text",
         [](const fs::path& file) { return errorOf(readWholeFile(file, kDescriptionLimit)); }},
        {"a mapped file", "a.anatomy", "bytes",
         [](const fs::path& file) { return errorOf(MappedFile::of(file, kCachedSetLimit)); }},
        {"a site", "site.json", R"({"schema":"carina.site/1"})",
         [](const fs::path& file) { return errorOf(readSiteFile(file)); }},
        {"a manikin", "manikin.json", R"({"schema":"carina.manikin/1"})",
         [](const fs::path& file) { return errorOf(readManikinFile(file)); }},
        {"landmarks", "marks.mrk.json", "{}",
         [](const fs::path& file) { return errorOf(importLandmarks(file, {})); }},
        {"corrections", "a.corrections.json", "{}",
         [](const fs::path& file) { return errorOf(readCorrections(file)); }},
        {"a cached set", "a.anatomy", "bytes",
         [](const fs::path& file) {
             fs::rename(file, file.parent_path() / (kHash + ".anatomy"));
             return errorOf(AnatomyCache{file.parent_path()}.load(kHash));
         }},
        {"a set of another computer", "a.anatomy", "bytes",
         [](const fs::path& file) {
             const CarriedSets sets{file.parent_path()};
             fs::create_directories(sets.file(kHash).parent_path());
             fs::rename(file, sets.file(kHash));
             return errorOf(sets.load(kHash, kHash));
         }},
        {"an OBJ", "a.obj", test::objOf({}),
         [](const fs::path& file) { return errorOf(SurfaceReader{}.read(file)); }},
        {"an STL", "a.stl", test::binaryStlOf({}),
         [](const fs::path& file) { return errorOf(SurfaceReader{}.read(file)); }},
        {"a GLB", "a.glb", test::glbOf({}),
         [](const fs::path& file) { return errorOf(SurfaceReader{}.read(file)); }},
    };
    return kReaders;
}

} // namespace

class TestFileLimit final : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<QTemporaryDir> m_temporary;
    fs::path m_folder;
    double m_timeBefore_s = 0.0;
    long m_memoryBefore_KiB = 0;

    bool wasCheap() const
    {
        return processorTime_s() - m_timeBefore_s < kShortTime_s
               && mostMemory_KiB() - m_memoryBefore_KiB < kLittleMemory_KiB;
    }

    /// A ball whose material names a picture.
    void writeSkin() const
    {
        test::writeFile(m_folder / "skin.mtl", "newmtl face\nmap_Kd face.png\n");
        test::writeFile(m_folder / "skin.obj",
                        test::texturedBallObj(1.0, 0.0, "mtllib skin.mtl\nusemtl face\n"));
        const auto red = [](double u, double) {
            return test::Pixel{static_cast<unsigned char>(255.0 * u), 0, 0};
        };
        test::writeFile(m_folder / "face.png", test::pngOf(64, test::pixelsOf(64, red)));
    }

private Q_SLOTS:
    void init()
    {
        m_temporary = std::make_unique<QTemporaryDir>();
        m_folder = m_temporary->path().toStdString();
        m_timeBefore_s = processorTime_s();
        m_memoryBefore_KiB = mostMemory_KiB();
    }

    void aTebibyteIsRefusedBeforeAnythingIsRead_data()
    {
        QTest::addColumn<int>("reader");
        for (std::size_t i = 0; i < readers().size(); ++i)
            QTest::newRow(readers()[i].name) << int(i);
    }

    void aTebibyteIsRefusedBeforeAnythingIsRead()
    {
        QFETCH(int, reader);
        const Reader& of = readers()[std::size_t(reader)];
        test::writeSparse(m_folder / of.file, of.head);
        const Error error = of.read(m_folder / of.file);
        QVERIFY2(error.code == Errc::FileTooLarge, error.detail.c_str());
        QVERIFY2(error.detail.find("it has 1048576 MiB, and a") != std::string::npos,
                 error.detail.c_str());
        QVERIFY(error.detail.starts_with(m_folder.string()));
        QVERIFY(wasCheap());
    }

    void theLimitItselfIsRead()
    {
        const FileLimit small{"a test", 1000};
        test::writeFile(m_folder / "just", std::string(1000, 'x'));
        test::writeFile(m_folder / "more", std::string(1001, 'x'));
        QCOMPARE(readWholeFile(m_folder / "just", small)->size(), std::size_t{1000});
        QCOMPARE(readableSize(m_folder / "just", small).value(), std::uint64_t{1000});
        QCOMPARE(readWholeFile(m_folder / "more", small).error(),
                 (Error{Errc::FileTooLarge, (m_folder / "more").string()
                                                + ": it has 1 MiB, and a test may have 1 MiB"}));
    }

    void theDocumentationSaysTheLimits_data()
    {
        QTest::addColumn<QString>("row");
        QTest::addColumn<qulonglong>("bytes");
        const auto row = [](const char* name, const FileLimit& limit) {
            QTest::newRow(name) << QString::fromLatin1(name) << qulonglong{limit.mostBytes};
        };
        row("surface: ", kSurfaceLimit);
        row("picture of a surface: ", kPictureLimit);
        row("material of a surface: ", kMaterialLimit);
        row("description: ", kDescriptionLimit);
        row("certificate, key", kCredentialLimit);
        row("measurement: ", kMeasurementLimit);
        row("patient of another computer ", kCarriedSetLimit);
        row("imported patient in the cache ", kCachedSetLimit);
    }

    void theDocumentationSaysTheLimits()
    {
        QFETCH(QString, row);
        QFETCH(qulonglong, bytes);
        const auto page =
            readWholeFile(fs::path{CARINA_SOURCE_DIR} / "docs" / "security.md", kDescriptionLimit);
        QVERIFY(page.has_value());
        const QString text = QString::fromStdString(*page);
        const QString line =
            text.section(QStringLiteral("\n| ") + row, 1, 1).section(QLatin1Char('\n'), 0, 0);
        const QString said = line.section(QStringLiteral("| "), 1, 1);
        QCOMPARE(said.section(QRegularExpression{QStringLiteral("[, ]")}, 0, 0).toULongLong(),
                 bytes / kMebibyte);
    }

    void aPipeIsNotWaitedFor()
    {
        QCOMPARE(mkfifo((m_folder / "pipe.obj").c_str(), 0600), 0);
        QCOMPARE(readableSize(m_folder / "pipe.obj", kSurfaceLimit).error().code,
                 Errc::FileUnreadable);
        QCOMPARE(SurfaceReader{}.read(m_folder / "pipe.obj").error().code, Errc::FileUnreadable);
    }

    void aFolderOfTebibytesIsHashedByItsSizes()
    {
        test::writeFile(m_folder / "Trachea.obj", test::objOf({}));
        for (const char* name : {"Lung.obj", "face.png", "skin.mtl", "MANIFEST.tsv", "SOURCE.txt"})
            test::writeSparse(m_folder / name, "LICENCE\n");
        const auto folder = listSetFolder(m_folder);
        QVERIFY(folder.has_value());
        const std::string before = contentHashOf(*folder);
        QVERIFY(missingFiles(*folder).empty());
        QVERIFY(attributionsBeside(*folder).empty());
        QVERIFY(wasCheap());
        test::writeSparse(m_folder / "face.png", "LICENCE\n", test::kTebibyte + 1);
        QVERIFY(contentHashOf(*folder) != before);
    }

    /// Larger than the piece in which it is hashed.
    void aHashIsThatOfAllBytes()
    {
        const std::string bytes(3'000'000, 'x');
        test::writeFile(m_folder / "a.obj", bytes);
        const auto folder = listSetFolder(m_folder);
        QCryptographicHash hash{QCryptographicHash::Sha256};
        hash.addData(QByteArray{"5 a.obj3000000 "}); // lengths and texts, as set_folder.cpp says
        hash.addData(QByteArray::fromStdString(bytes));
        QCOMPARE(contentHashOf(*folder), hash.result().toHex().toStdString());
    }

    void aPictureOrMaterialOfATebibyteLeavesTheSurfaceAndIsSaid_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("picture") << QStringLiteral("face.png");
        QTest::newRow("material") << QStringLiteral("skin.mtl");
    }

    void aPictureOrMaterialOfATebibyteLeavesTheSurfaceAndIsSaid()
    {
        QFETCH(QString, file);
        writeSkin();
        const auto whole = SurfaceReader{}.read(m_folder / "skin.obj");
        QVERIFY(whole.has_value() && !whole->surfaces[0].colors.empty());
        fs::resize_file(m_folder / file.toStdString(), test::kTebibyte);
        const auto read = SurfaceReader{}.read(m_folder / "skin.obj");
        QVERIFY2(read.has_value(), read ? "" : read.error().detail.c_str());
        QVERIFY(read->surfaces[0].colors.empty());
        QCOMPARE(read->textureFaults.size(), std::size_t{1});
        QCOMPARE(read->textureFaults[0].code, Errc::FileTooLarge);
        QVERIFY(read->textureFaults[0].detail.find(file.toStdString()) != std::string::npos);
        QVERIFY(wasCheap());
    }

    void aBufferOfATebibyteIsRefused()
    {
        test::writeFile(m_folder / "scene.gltf", test::gltfJson("scene.bin"));
        test::writeSparse(m_folder / "scene.bin", test::gltfBuffer({}));
        const auto read = SurfaceReader{}.read(m_folder / "scene.gltf");
        QCOMPARE(errorOf(read).code, Errc::FileTooLarge);
        QVERIFY(wasCheap());
    }
};

CARINA_TEST(TestFileLimit)

} // namespace carina::file_limit_test

#include "tst_file_limit.moc"
