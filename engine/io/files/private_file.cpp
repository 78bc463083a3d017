#include "engine/io/files/private_file.h"

#include <QFileInfo>

namespace carina
{

bool openPrivately(QFile& file, QIODevice::OpenMode mode)
{
    if (!file.open(mode, kOwnerOnly))
        return false;
    if (!QFileInfo{file.fileName()}.isFile() || file.setPermissions(kOwnerOnly))
        return true;
    file.close(); // it is somebody else's, who let us write it, and may read it
    return false;
}

} // namespace carina
