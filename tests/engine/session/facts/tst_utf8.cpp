#include "engine/session/facts/utf8.h"
#include "tests/support/test_class.h"

namespace carina::utf8_test
{

/// Rows from RFC 3629: the table of well-formed sequences and its edges.
class TestUtf8 : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void acceptsWellFormedTextOnly_data();
    void acceptsWellFormedTextOnly();
};

void TestUtf8::acceptsWellFormedTextOnly_data()
{
    QTest::addColumn<QByteArray>("hex");
    QTest::addColumn<bool>("wellFormed");
    const auto row = [](const char* name, const char* hex, bool wellFormed) {
        QTest::newRow(name) << QByteArray{hex} << wellFormed;
    };
    row("empty", "", true);
    row("first ASCII", "00", true);
    row("last ASCII", "7f", true);
    row("continuation alone", "80", false);
    row("last continuation alone", "bf", false);
    row("overlong two bytes, C0", "c080", false);
    row("overlong two bytes, C1", "c1bf", false);
    row("first of two bytes", "c280", true);
    row("last of two bytes", "dfbf", true);
    row("two bytes, second too low", "c27f", false);
    row("two bytes, second too high", "c2c0", false);
    row("overlong three bytes", "e09fbf", false);
    row("first of three bytes", "e0a080", true);
    row("E0 with its last second byte", "e0bfbf", true);
    row("E0 with a second byte too high", "e0c080", false);
    row("E1 with its first second byte", "e18080", true);
    row("E1 with a second byte too low", "e17f80", false);
    row("EC, last before the surrogates' lead", "ecbfbf", true);
    row("last before the surrogates", "ed9fbf", true);
    row("ED with its first second byte", "ed8080", true);
    row("ED with a second byte too low", "ed7f80", false);
    row("first surrogate", "eda080", false);
    row("EE, first after the surrogates", "ee8080", true);
    row("last of three bytes", "efbfbf", true);
    row("EF with a second byte too high", "efc080", false);
    row("three bytes, third too low", "e1807f", false);
    row("three bytes, third too high", "e180c0", false);
    row("E0 with a third byte below its second's range", "e0a09f", true);
    row("ED with a third byte above its second's range", "ed80bf", true);
    row("overlong four bytes", "f08fbfbf", false);
    row("first of four bytes", "f0908080", true);
    row("F0 with its last second byte", "f0bfbfbf", true);
    row("F0 with a second byte too high", "f0c08080", false);
    row("F1 with its first second byte", "f1808080", true);
    row("F1 with a second byte too low", "f17f8080", false);
    row("F3 with its last second byte", "f3bfbfbf", true);
    row("F3 with a second byte too high", "f3c08080", false);
    row("last character", "f48fbfbf", true);
    row("F4 with its first second byte", "f4808080", true);
    row("F4 with a second byte too low", "f47f8080", false);
    row("beyond the last character", "f4908080", false);
    row("F5 begins nothing", "f5808080", false);
    row("FF begins nothing", "ff", false);
    row("four bytes, fourth too low", "f180807f", false);
    row("two bytes cut off", "c2", false);
    row("three bytes cut off", "e180", false);
    row("four bytes cut off", "f18080", false);
    row("ASCII where a byte should follow", "e18041", false);
    row("several characters", "5a6fc3a9e282acf09f9881", true);
    row("a fault after good text", "5a6fc3a9c3", false);
}

void TestUtf8::acceptsWellFormedTextOnly()
{
    QFETCH(const QByteArray, hex);
    QFETCH(const bool, wellFormed);
    QCOMPARE(isUtf8(QByteArray::fromHex(hex).toStdString()), wellFormed);
}

CARINA_TEST(TestUtf8)

} // namespace carina::utf8_test

#include "tst_utf8.moc"
