#include "tests/support/test_class.h"
#include "widgets/qr_code.h"

#include <QImage>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace carina::qr_code_test
{
namespace
{

constexpr double kRatio = 1.5; ///< of screen pixels to Qt's: the one that makes edges blur
const QString kLink =
    QStringLiteral("carina:join?address=192.0.2.7&port=45000&role=trainee&code=7K3QM-XW2PD");

/// In a dark theme, so wide and high in the screen's own pixels.
std::unique_ptr<QrCode> codeOf(const QString& text, QSize pixels)
{
    auto code = std::make_unique<QrCode>();
    QPalette palette;
    palette.setColor(QPalette::Window, Qt::black);
    palette.setColor(QPalette::WindowText, Qt::yellow);
    code->setPalette(palette);
    code->setText(text);
    code->resize(pixels / kRatio);
    return code;
}

QImage painted(QrCode& code) { return code.grab().toImage().convertToFormat(QImage::Format_RGB32); }

/// What the colours of one module are: black, white, or something else.
QString colourAt(const QImage& image, const QrCode::Drawing& drawn, int column, int row)
{
    const QPoint corner =
        drawn.field.topLeft() + (QPoint{column, row} + QPoint{4, 4}) * drawn.pixelsPerModule;
    const QRgb first = image.pixel(corner);
    for (int y = 0; y < drawn.pixelsPerModule; ++y)
        for (int x = 0; x < drawn.pixelsPerModule; ++x)
            if (image.pixel(corner + QPoint{x, y}) != first)
                return QStringLiteral("blurred");
    return first == qRgb(0, 0, 0)         ? QStringLiteral("black")
           : first == qRgb(255, 255, 255) ? QStringLiteral("white")
                                          : QStringLiteral("other");
}

QByteArray readByZbar(const QImage& image)
{
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("code.png"));
    image.save(file);
    QProcess zbar;
    zbar.start(QStringLiteral("zbarimg"),
               {QStringLiteral("--quiet"), QStringLiteral("--raw"), QStringLiteral("-Sdisable"),
                QStringLiteral("-Sqrcode.enable"), file});
    zbar.waitForFinished();
    return zbar.readAllStandardOutput().trimmed();
}

} // namespace

class TestQrCode : public QObject
{
    Q_OBJECT

public:
    static void initMain() { qputenv("QT_SCALE_FACTOR", QByteArray::number(kRatio)); }

private Q_SLOTS:
    void isReadBackByOthersSoftware_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QSize>("pixels");
        QTest::newRow("link, as small as it may be") << kLink << QSize{135, 135};
        QTest::newRow("link, in a wide place") << kLink << QSize{900, 300};
        QTest::newRow("link, in a high place") << kLink << QSize{300, 900};
        QTest::newRow("one letter") << QStringLiteral("a") << QSize{120, 120};
        QString all;
        for (char c = '!'; c <= '~'; ++c)
            all += QLatin1Char{c};
        QTest::newRow("every character") << all << QSize{300, 300};
        QTest::newRow("a long text") << QString(1000, QLatin1Char{'x'}) << QSize{600, 600};
    }
    void isReadBackByOthersSoftware()
    {
        if (QStandardPaths::findExecutable(QStringLiteral("zbarimg")).isEmpty())
            QSKIP("zbarimg of the Debian package zbar-tools is not installed");
        QFETCH(const QString, text);
        QFETCH(const QSize, pixels);
        const auto code = codeOf(text, pixels);
        QCOMPARE(readByZbar(painted(*code)), text.toUtf8());
    }

    void modulesAreCrispAndBlackOrWhite()
    {
        const auto code = codeOf(kLink, {400, 420});
        const QrCode::Drawing drawn = code->drawing();
        QCOMPARE(drawn.modules, 37); // version 5: up to 84 bytes with correction M
        QCOMPARE(drawn.pixelsPerModule, 400 / 45);
        const QImage image = painted(*code);
        std::size_t black = 0;
        for (int row = 0; row < drawn.modules; ++row)
            for (int column = 0; column < drawn.modules; ++column) {
                const QString colour = colourAt(image, drawn, column, row);
                QVERIFY2(colour == QStringLiteral("black") || colour == QStringLiteral("white"),
                         qPrintable(colour));
                black += colour == QStringLiteral("black");
            }
        QCOMPARE(black, drawn.dark.size());
    }

    void finderPatternsLieInThreeCorners()
    {
        // ISO/IEC 18004, 6.3.3: seven modules square, black, white and black rings.
        const auto code = codeOf(kLink, {300, 300});
        const QrCode::Drawing drawn = code->drawing();
        const QImage image = painted(*code);
        const int far = drawn.modules - 7;
        for (const QPoint corner : {QPoint{0, 0}, QPoint{far, 0}, QPoint{0, far}})
            for (int y = 0; y < 7; ++y)
                for (int x = 0; x < 7; ++x) {
                    const int ring = std::max(std::abs(x - 3), std::abs(y - 3));
                    QCOMPARE(colourAt(image, drawn, corner.x() + x, corner.y() + y),
                             ring == 2 ? QStringLiteral("white") : QStringLiteral("black"));
                }
    }

    void fourWhiteModulesLieAround()
    {
        const auto code = codeOf(kLink, {300, 300});
        const QrCode::Drawing drawn = code->drawing();
        const QImage image = painted(*code);
        const int last = drawn.modules + 4;
        for (int i = -4; i < last; ++i)
            for (const int edge : {-4, -1, drawn.modules, last - 1}) {
                QCOMPARE(colourAt(image, drawn, i, edge), QStringLiteral("white"));
                QCOMPARE(colourAt(image, drawn, edge, i), QStringLiteral("white"));
            }
        const QPoint outside = drawn.field.topLeft() - QPoint{1, 1};
        QVERIFY(image.pixel(outside) != qRgb(255, 255, 255)); // the theme's own again
    }

    void isAsLargeAsFitsAndInTheMiddle()
    {
        const auto code = codeOf(kLink, {600, 150});
        const QrCode::Drawing drawn = code->drawing();
        QCOMPARE(drawn.pixelsPerModule, 3);
        QCOMPARE(drawn.field, QRect((600 - 135) / 2, (150 - 135) / 2, 135, 135));
        code->resize(20, 20);
        QCOMPARE(code->drawing().pixelsPerModule, 0);
        QVERIFY(code->drawing().dark.empty());
    }

    void asksForRoomForItsModules()
    {
        const QrCode empty;
        QVERIFY(empty.minimumSizeHint().isEmpty());
        QCOMPARE(empty.drawing().modules, 0);
        const auto code = codeOf(kLink, {});
        QCOMPARE(code->minimumSizeHint(), QSize(3 * 45, 3 * 45));
        QCOMPARE(code->sizeHint(), QSize(4 * 45, 4 * 45));
        code->setText(QString{});
        QCOMPARE(code->drawing().modules, 0);
        QVERIFY(code->sizeHint().isEmpty());
    }

    void largestTextThereIsHasACode()
    {
        const auto code = codeOf(QString(QrCode::kMostCharacters, QLatin1Char{'x'}), {800, 800});
        QCOMPARE(code->drawing().modules, 177); // version 40
    }

    void tellsAScreenReaderItsTextAndTakesNoFocus()
    {
        const auto code = codeOf(kLink, {300, 300});
        QCOMPARE(code->accessibleDescription(), kLink);
        QCOMPARE(code->focusPolicy(), Qt::NoFocus);
    }
};

CARINA_SCREEN_TEST(TestQrCode)

} // namespace carina::qr_code_test

#include "tst_qr_code.moc"
