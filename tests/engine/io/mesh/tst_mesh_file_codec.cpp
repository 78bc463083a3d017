#include "engine/core/byte_buffer.h"
#include "engine/io/mesh/mesh_file_codec.h"
#include "engine/io/mesh/reader_memory.h"
#include "tests/support/test_class.h"

namespace carina::mesh_file_codec_test
{
namespace
{

constexpr std::size_t kEmptySurface = 6 * sizeof(std::uint32_t); ///< counts of 0
constexpr std::size_t kEmptyLine = sizeof(std::uint32_t);

/// An answer with so many empty surfaces and lines, as a reader that was taken over may give.
std::vector<std::byte> answer(std::size_t surfaces, std::size_t lines)
{
    std::vector<std::byte> bytes;
    ByteWriter writer{bytes};
    writer.number(std::uint8_t{0});
    writer.number(static_cast<std::uint32_t>(surfaces));
    bytes.resize(bytes.size() + surfaces * kEmptySurface);
    writer.number(static_cast<std::uint32_t>(lines));
    bytes.resize(bytes.size() + lines * kEmptyLine);
    writer.number(std::uint32_t{0});
    return bytes;
}

} // namespace

class TestMeshFileCodec : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void answerHoldsNoMorePartsThanMemoryIsFor_data()
    {
        QTest::addColumn<qulonglong>("surfaces");
        QTest::addColumn<qulonglong>("lines");
        QTest::addColumn<bool>("isTaken");
        const qulonglong most = kMostParts;
        QTest::newRow("few") << qulonglong{3} << qulonglong{2} << true;
        QTest::newRow("as many lines as there may be") << qulonglong{0} << most << true;
        QTest::newRow("a line too many") << qulonglong{0} << most + 1 << false;
        QTest::newRow("a surface too many") << most + 1 << qulonglong{0} << false;
    }
    void answerHoldsNoMorePartsThanMemoryIsFor()
    {
        QFETCH(const qulonglong, surfaces);
        QFETCH(const qulonglong, lines);
        QFETCH(const bool, isTaken);
        const auto read = decodeMeshFile(answer(surfaces, lines));
        QCOMPARE(read.has_value(), isTaken);
        if (!isTaken)
            QCOMPARE(read.error().code, Errc::FileMalformed);
        else
            QCOMPARE(std::size_t((*read)->attributions.size()), std::size_t(lines));
    }

    void fileOfTooManyPartsIsAnsweredWithWords()
    {
        MeshFile file;
        file.attributions.resize(kMostParts + 1);
        const auto read = decodeMeshFile(encodeMeshFile(file));
        QVERIFY(read && !*read);
        QCOMPARE(read->error().code, Errc::FileTooLarge);
    }

    void answerIsNoLongerThanAReaderCanMakeIt()
    {
        for (unsigned shares = 1; shares <= ReaderMemory::shares(); ++shares) {
            QVERIFY(2 * ReaderMemory::longestAnswer(shares) <= ReaderMemory::bytesOf(shares));
            QVERIFY(ReaderMemory::longestAnswer(shares) > 0);
        }
    }
};

CARINA_TEST(TestMeshFileCodec)

} // namespace carina::mesh_file_codec_test

#include "tst_mesh_file_codec.moc"
