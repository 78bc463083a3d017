#include "tests/engine/tracking/igtl/igtl_samples.h"
#include "tests/support/hex.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QFile>
#include <QFileInfo>

namespace carina::igtl_vectors_test
{
namespace
{

using test::streamOf;

/// A row for each file in a folder of the real data; one without a name where there is none.
void addFiles(const char* folder)
{
    QTest::addColumn<QString>("path");
    const auto files = test::testData(folder);
    if (!files) {
        QTest::newRow("no data") << QString{};
        return;
    }
    for (const auto& file : std::filesystem::directory_iterator{*files})
        QTest::newRow(file.path().filename().c_str())
            << QString::fromStdString(file.path().string());
}

QByteArray bytesOf(const QString& path)
{
    QFile file{path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
}

std::span<const std::byte> spanOf(const QByteArray& bytes)
{
    return std::as_bytes(std::span{bytes.constData(), std::size_t(bytes.size())});
}

} // namespace

class IgtlVectorsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void decodesAndEncodesWhatMustBeAccepted_data() { addFiles("openigtlink/accept"); }

    void decodesAndEncodesWhatMustBeAccepted()
    {
        QFETCH(const QString, path);
        if (path.isEmpty())
            QSKIP("the real data are not here");
        const QByteArray bytes = bytesOf(path);
        QVERIFY(!bytes.isEmpty());
        const auto stream = streamOf(spanOf(bytes));
        QCOMPARE(stream.messages.size(), std::size_t{1});
        QVERIFY(stream.refused == 0 && !stream.isWithin);
        QCOMPARE(toHex(encodeIgtl(stream.messages[0])), toHex(spanOf(bytes)));
    }

    void refusesWhatMustBeRefused_data() { addFiles("openigtlink/reject"); }

    void refusesWhatMustBeRefused()
    {
        QFETCH(const QString, path);
        if (path.isEmpty())
            QSKIP("the real data are not here");
        const QByteArray bytes = bytesOf(path);
        QVERIFY(!bytes.isEmpty());
        const auto stream = streamOf(spanOf(bytes));
        QVERIFY(stream.messages.empty());
        // Only one that is cut is waited for.
        const bool isCut = QFileInfo{path}.fileName() == QStringLiteral("truncated_42.bin");
        QCOMPARE(stream.isWithin, isCut);
        QCOMPARE(int(stream.refused), isCut ? 0 : 1);
    }
};

CARINA_TEST(IgtlVectorsTest)

} // namespace carina::igtl_vectors_test

#include "tst_igtl_vectors.moc"
