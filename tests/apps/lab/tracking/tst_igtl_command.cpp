#include "apps/lab/commands.h"
#include "tests/engine/tracking/igtl/igtl_samples.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

#include <QJsonArray>

namespace carina::lab::igtl_command_test
{
namespace
{

QByteArray bytesOf(const IgtlMessage& message)
{
    const auto bytes = encodeIgtl(message);
    return {reinterpret_cast<const char*>(bytes.data()), qsizetype(bytes.size())};
}

} // namespace

class IgtlCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void printsWhatAConnectionTells()
    {
        const test::ScratchFolder folder;
        IgtlMessage seen = test::messageOf(IgtlTransform{test::kQuarterTurn});
        seen.version = 2;
        seen.stamp = (std::uint64_t{10} << 32U) + 0x8000'0000U;
        seen.metadata = {{"TransformStatus", 3, "OK"}};
        QByteArray damaged = bytesOf(seen);
        damaged.back() = 'x';
        const QByteArray status = bytesOf(test::messageOf(IgtlStatus{1, 0, "", "Well."}));
        const QString path = folder.write(
            "igtl.bin", bytesOf(seen) + damaged + bytesOf(test::messageOf(IgtlQuery{"IMAGE"}))
                            + status + status.left(60));
        const auto object = igtlCommand().run({QStringLiteral("decode"), path});
        QVERIFY(object);
        const QJsonArray messages = (*object)[QLatin1StringView{"messages"}].toArray();
        QCOMPARE(messages.size(), 3);
        const QJsonObject first = messages[0].toObject();
        QCOMPARE(first[QLatin1StringView{"type"}].toString(), QStringLiteral("TRANSFORM"));
        QCOMPARE(first[QLatin1StringView{"device"}].toString(), QStringLiteral("Tube"));
        QCOMPARE(first[QLatin1StringView{"version"}].toInt(), 2);
        QCOMPARE(first[QLatin1StringView{"time_s"}].toDouble(), 10.5);
        QVERIFY(first[QLatin1StringView{"reencodes"}].toBool());
        QCOMPARE(first[QLatin1StringView{"metadata"}].toObject(),
                 (QJsonObject{{QStringLiteral("TransformStatus"), QStringLiteral("OK")}}));
        const QJsonArray p_mm = first[QLatin1StringView{"poses"}]
                                    .toArray()[0]
                                    .toObject()[QLatin1StringView{"p_mm"}]
                                    .toArray();
        QVERIFY(std::abs(p_mm[1].toDouble() + 20.0) < 1e-6);
        QVERIFY(messages[1].toObject()[QLatin1StringView{"skipped"}].toBool());
        QCOMPARE(messages[2].toObject()[QLatin1StringView{"text"}].toString(),
                 QStringLiteral("Well."));
        const QJsonArray refused = (*object)[QLatin1StringView{"refused"}].toArray();
        QCOMPARE(refused.size(), 2);
        QCOMPARE(refused[0].toString(), QStringLiteral("TRANSFORM: checksum"));
        QVERIFY(refused[1].toString().contains(QStringLiteral("missing")));
        QVERIFY((*object)[kAcceptable].toBool());
    }

    void isNotAcceptableWhereEverythingIsRefused()
    {
        const test::ScratchFolder folder;
        QByteArray damaged = bytesOf(test::messageOf(IgtlTransform{test::kQuarterTurn}));
        damaged.back() = 'x';
        const QString path = folder.write("igtl.bin", damaged);
        const auto object = igtlCommand().run({QStringLiteral("decode"), path});
        QVERIFY(object);
        QCOMPARE((*object)[QLatin1StringView{"refused"}].toArray().size(), 1);
        QVERIFY(!(*object)[kAcceptable].toBool(true));
    }

    void refusesOtherWords()
    {
        for (const QStringList& words : {QStringList{},
                                         {QStringLiteral("decode")},
                                         {QStringLiteral("encode"), QStringLiteral("x")}}) {
            const auto object = igtlCommand().run(words);
            QVERIFY(!object);
            QCOMPARE(object.error().code, Errc::WrongOption);
        }
        const auto missing =
            igtlCommand().run({QStringLiteral("decode"), QStringLiteral("nowhere.bin")});
        QVERIFY(!missing);
        QCOMPARE(missing.error().code, Errc::FileNotFound);
    }
};

CARINA_TEST(IgtlCommandTest)

} // namespace carina::lab::igtl_command_test

#include "tst_igtl_command.moc"
