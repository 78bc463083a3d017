#include "tests/engine/lungs/lung_like_mesh.h"
#include "widgets/scene/drawn_vertices.h"

#include <QTest>

using namespace carina;

class TestNoGraphics : public QObject
{
    Q_OBJECT

public:
    /// Without a display the offscreen platform has no OpenGL.
    static void initMain()
    {
        qputenv("QT_QPA_PLATFORM", "offscreen");
        qunsetenv("DISPLAY");
        qunsetenv("WAYLAND_DISPLAY");
    }

private Q_SLOTS:
    void saysThatNothingCanBeDrawn();
};

void TestNoGraphics::saysThatNothingCanBeDrawn()
{
    const TriangleMesh mesh = test::lungLikeMesh(Vec3::Zero(), Vec3::Constant(0.1), 4, 8);
    const Result<DrawnVertices> drawn = DrawnVertices::of(mesh);
    QVERIFY(!drawn);
    QCOMPARE(drawn.error().code, Errc::NoGraphics);
}

QTEST_MAIN(TestNoGraphics)
#include "tst_no_graphics.moc"
