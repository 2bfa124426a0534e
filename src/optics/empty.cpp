namespace snell {}
