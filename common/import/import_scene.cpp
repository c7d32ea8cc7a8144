#include "common/import/import_model.h"
#include "common/import/import_nff.h"

namespace twintrace {

ImportedScene importScene(const std::string& path) {
  return isNffName(path) ? importNff(path) : importModel(path);
}

}  // namespace twintrace
