#include "ui/tracker/tool_layout_dialog.h"

#include "tests/support/test_class.h"
#include "widgets/marker_layout.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>

#include <fstream>

namespace carina::tool_layout_dialog_test
{
namespace
{

template <class Widget> Widget& find(const QWidget& window, const char* name)
{
    return *window.findChild<Widget*>(QLatin1String{name});
}

} // namespace

class ToolLayoutDialogTest : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    QString path(const char* name) const { return m_folder.filePath(QLatin1String{name}); }

private Q_SLOTS:
    void initTestCase()
    {
        const std::vector<ToolMarker> markers{{{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0.01}}};
        const auto tool =
            NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", "tube");
        const auto& bytes = tool.value().bytes();
        std::ofstream{path("tube.rom").toStdString(), std::ios::binary}.write(
            reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    }

    void showsMovesAndSavesMarkers()
    {
        ToolLayoutDialog dialog;
        QVERIFY(!find<QPushButton>(dialog, "layoutSave").isEnabled());
        dialog.openFile(path("tube.rom"));
        auto& number = find<QSpinBox>(dialog, "layoutMarker");
        auto& y = find<QDoubleSpinBox>(dialog, "layoutY");
        QCOMPARE(number.maximum(), 3);
        number.setValue(3);
        QCOMPARE(y.value(), 80.0);
        QCOMPARE(find<MarkerLayout>(dialog, "layoutPicture").selected(), 2);
        y.setValue(82.5);
        QVERIFY(!find<QPushButton>(dialog, "layoutOpen").isEnabled());
        find<QPushButton>(dialog, "layoutUndo").click();
        QCOMPARE(y.value(), 80.0);
        find<QPushButton>(dialog, "layoutRedo").click();
        QCOMPARE(y.value(), 82.5);
        dialog.saveTo(path("tube.rom"));
        QVERIFY(find<QLabel>(dialog, "layoutMessage").text().contains(QStringLiteral("tube.rom")));
        QVERIFY(dialog.layoutShown().isChanged());
        dialog.saveTo(path("moved"));
        QVERIFY(!dialog.layoutShown().isChanged());
        QVERIFY(QFile::exists(path("moved.rom")));
    }

    /// Two markers and a third on the line through them.
    void keepsAMarkerWhoseNewPlaceIsRefused()
    {
        ToolLayoutDialog dialog;
        dialog.openFile(path("tube.rom"));
        find<QSpinBox>(dialog, "layoutMarker").setValue(3);
        find<QDoubleSpinBox>(dialog, "layoutZ").setValue(0.0);
        auto& y = find<QDoubleSpinBox>(dialog, "layoutY");
        y.setValue(0.0);
        QVERIFY(!find<QLabel>(dialog, "layoutMessage").text().isEmpty());
        QCOMPARE(y.value(), 80.0);
    }

    void everythingHasAnAccessibleName()
    {
        ToolLayoutDialog dialog;
        for (const char* name : {"layoutX", "layoutY", "layoutZ", "layoutMarker"})
            QVERIFY2(!find<QWidget>(dialog, name).accessibleName().isEmpty(), name);
        QVERIFY(!find<MarkerLayout>(dialog, "layoutPicture").accessibleName().isEmpty());
    }
};

CARINA_SCREEN_TEST(ToolLayoutDialogTest)

} // namespace carina::tool_layout_dialog_test

#include "tst_tool_layout_dialog.moc"
