#include "models/tracker/tool_layout.h"

#include "tests/support/test_class.h"

#include <QSignalSpy>
#include <QTemporaryDir>

#include <fstream>

namespace carina::tool_layout_test
{
namespace
{

const std::vector<ToolMarker> kMarkers{
    {{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0}}, {{0.01, 0.02, 0.03}}};

} // namespace

class ToolLayoutTest : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_folder;

    std::filesystem::path path(const char* name) const
    {
        return std::filesystem::path{m_folder.path().toStdString()} / name;
    }

private Q_SLOTS:
    void init()
    {
        const auto tool =
            NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, kMarkers, "Carina", "tube");
        const auto& bytes = tool.value().bytes();
        std::ofstream{path("tube.rom"), std::ios::binary}.write(
            reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
        std::filesystem::remove(path("moved.rom"));
    }

    void tellsTheMarkersInMillimetres()
    {
        ToolLayout layout;
        QVERIFY(!layout.isOpen() && layout.markers_mm().empty());
        QVERIFY(layout.open(path("tube.rom")));
        const auto markers = layout.markers_mm();
        QCOMPARE(markers.size(), 4U);
        QVERIFY((markers[3] - Vec3{10.0, 20.0, 30.0}).norm() < 1e-5);
        QVERIFY(layout.title().contains(QStringLiteral("tube.rom")));
    }

    void undoesAndRedoesEveryMove()
    {
        ToolLayout layout;
        QVERIFY(layout.open(path("tube.rom")));
        const QSignalSpy told{&layout, &ToolLayout::changed};
        QVERIFY(layout.move(3, {11.0, 20.0, 30.0}));
        QVERIFY(layout.move(3, {12.0, 20.0, 30.0}));
        QVERIFY(layout.isChanged());
        layout.undo();
        QVERIFY(std::abs(layout.markers_mm()[3].x() - 11.0) < 1e-5);
        layout.undo();
        QVERIFY(!layout.isChanged() && !layout.canUndo());
        layout.undo(); // there is nothing
        layout.redo();
        layout.redo();
        QVERIFY(std::abs(layout.markers_mm()[3].x() - 12.0) < 1e-5);
        QVERIFY(!layout.canRedo());
        QCOMPARE(told.count(), 6);
    }

    void aNewMoveReplacesWhatWasUndone()
    {
        ToolLayout layout;
        QVERIFY(layout.open(path("tube.rom")));
        QVERIFY(layout.move(3, {11.0, 20.0, 30.0}));
        QVERIFY(layout.saveAs(path("moved.rom")));
        layout.undo();
        QVERIFY(layout.move(3, {13.0, 20.0, 30.0}));
        QVERIFY(!layout.canRedo());
        QVERIFY(layout.isChanged()); // the state of the file is gone
        layout.undo();
        QVERIFY(layout.isChanged());
    }

    void keepsWhatWasBeforeAPlaceThatIsRefused()
    {
        ToolLayout layout;
        QVERIFY(layout.open(path("tube.rom")));
        const auto moved = layout.move(3, {5000.0, 0.0, 0.0});
        QVERIFY(!moved);
        QCOMPARE(moved.error().code, Errc::OutOfRange);
        QVERIFY(!layout.isChanged() && !layout.canUndo());
        QVERIFY(layout.move(3, layout.markers_mm()[3])); // the same place is no move
        QVERIFY(!layout.canUndo());
    }

    void savesANewFileAndReplacesNone()
    {
        ToolLayout layout;
        QVERIFY(layout.open(path("tube.rom")));
        QVERIFY(layout.move(3, {11.0, 20.0, 30.0}));
        const auto over = layout.saveAs(path("tube.rom"));
        QVERIFY(!over);
        QCOMPARE(over.error().code, Errc::FileUnwritable);
        QVERIFY(layout.isChanged());
        QVERIFY(layout.saveAs(path("moved.rom")));
        QVERIFY(!layout.isChanged());
        ToolLayout read;
        QVERIFY(read.open(path("moved.rom")));
        QVERIFY(std::abs(read.markers_mm()[3].x() - 11.0) < 1e-5);
        ToolLayout old;
        QVERIFY(old.open(path("tube.rom")));
        QVERIFY(std::abs(old.markers_mm()[3].x() - 10.0) < 1e-5);
    }

    void keepsWhatIsOpenWhereAnotherFileCannotBeRead()
    {
        ToolLayout layout;
        QVERIFY(layout.open(path("tube.rom")));
        std::ofstream{path("bad.rom")} << "NDI";
        QVERIFY(!layout.open(path("bad.rom")));
        QVERIFY(!layout.open(path("none.rom")));
        QCOMPARE(layout.markers_mm().size(), 4U);
    }
};

CARINA_TEST(ToolLayoutTest)

} // namespace carina::tool_layout_test

#include "tst_tool_layout.moc"
