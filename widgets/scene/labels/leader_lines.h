#pragma once

#include <QLineF>
#include <QWidget>

#include <vector>

namespace carina
{

/// Lines from names to the points they name, over a picture that is a native window: a native
/// window of the shape of the lines, so that the picture shows beside them. Each begins with a dot.
/// It does not receive mouse or keys.
class LeaderLines : public QWidget
{
    Q_OBJECT

public:
    explicit LeaderLines(QWidget& over);

    /// Draws these lines, each from its dot, in pixels of the picture; hidden without any.
    void setLines(const std::vector<QLineF>& lines);
    [[nodiscard]] const std::vector<QLineF>& lines() const { return m_lines; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<QLineF> m_lines;
};

} // namespace carina
